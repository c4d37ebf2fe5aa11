// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/diagnosis/fault.hpp>
#include <carom/properties/diagnosis/where.hpp>

namespace carom::properties::diagnosis {

/// The faults that the answers of a subject show, each with its cases and its witness. The fault with most cases is
/// first. Precondition: `violations` lists the violated sampled cases of the result, and there is one.
[[nodiscard]] std::vector<Fault> faults_of(const SubjectResult& result, const GateReport& report,
                                           const Violations& violations);

}  // namespace carom::properties::diagnosis
