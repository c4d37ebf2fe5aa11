// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <pugixml.hpp>

#include <carom/collision/subject.hpp>
#include <carom/properties/gate/trial.hpp>

namespace carom::report {

/// Appends a figure of the contact: before the impulse, as the subject answered, and exactly under the law `claimed`.
/// `anchor` is unique in its page. `title` names the contact.
void add_case_drawing(pugi::xml_node section, const properties::JudgedCase& judged_case, const Answer& answer,
                      Law claimed, const std::string& anchor, const std::string& title);

}  // namespace carom::report
