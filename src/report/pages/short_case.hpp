// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/subject.hpp>
#include <carom/properties/gate/gate_report.hpp>

namespace carom::report {

/// A witness for a first look: A, B, the contact, the law's answer, the subject's answer, and the violated invariant.
/// These are six lines, longer ones wrapped. Numbers are rounded, and defaults are left out. The answers have only the
/// vectors that differ. The law's answer is missing for `any`.
[[nodiscard]] std::string short_case(const properties::Witness& witness, const Subject& subject);

}  // namespace carom::report
