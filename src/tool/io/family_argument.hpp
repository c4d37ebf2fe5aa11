// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/families/family.hpp>

namespace carom::tool {

/// The family that the command line names with this option. Throws UsageError if there is none; the message names the
/// known families.
[[nodiscard]] const properties::Family& family_from_argument(const std::string& option, const std::string& name);

}  // namespace carom::tool
