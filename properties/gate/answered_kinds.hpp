// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

/// Says where a subject that skips more than a tenth of the cases answers, and the domain for `--within` that fits: "it
/// answered only contacts in the plane z = 0: add --within plane=xy". The answered ones of the sampled cases have a
/// kind or a coefficient in common that the skipped ones lack.
[[nodiscard]] std::string what_it_answers(const SubjectResult& result, const GateReport& report);

}  // namespace carom::properties
