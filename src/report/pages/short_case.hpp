// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/subject.hpp>
#include <carom/properties/gate/gate_report.hpp>

namespace carom::report {

/// A witness for a first look, at most six lines of it if the subject answered: A, B, the contact, the law's answer,
/// the subject's answer, and the violated invariant. Numbers are rounded, and defaults are left out. Of the answers, it
/// has only the vectors that differ. The law's answer is missing for `any`.
[[nodiscard]] std::string short_case(const properties::Witness& witness, const Subject& subject);

}  // namespace carom::report
