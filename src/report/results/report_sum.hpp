// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/gate/gate_report.hpp>

/// The sum of the reports of several shards. First add the reports in the order of their shards, then complete the sum.
namespace carom::report {

/// Adds counts, coverage, worst cases, digits and witnesses. Precondition: both reports are of the same run.
void add_report(properties::GateReport& sum, const properties::GateReport& part);

/// Makes the sum a report of `shard`, which consists of the added shards: draws its sample, and states if too few cases
/// were judged.
void complete_sum(properties::GateReport& sum, const properties::Shard& shard);

/// Completes the sum of all parts of the run that `options` describe, then finds its witnesses. Preconditions:
/// `options` have no budget, and are not `fail_fast`; `subjects` are those of the parts, and open sessions.
void complete_run(properties::GateReport& sum, const properties::GateOptions& options,
                  const std::vector<Subject>& subjects);

}  // namespace carom::report
