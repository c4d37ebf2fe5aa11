// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

/// Seeks the ways on of each subject that counts and violates an invariant. The violated sampled cases suggest domains
/// and effects, and the gate judges the subject anew on fresh cases. It poses at most about as many cases as the run
/// did. Does nothing for a part of a run, after a run that ended early, or with `fail_fast`. If a subject or the judge
/// fails, that subject has no way on. Preconditions: `counts` has an element for each result; the subjects open
/// sessions.
void add_ways_on(GateReport& report, const std::vector<bool>& counts);

}  // namespace carom::properties
