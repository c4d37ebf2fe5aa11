// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/gate/gate_report.hpp>

/// The sum of the reports of several shards. First add the reports in the order of their shards, then complete the sum.
namespace carom::report {

/// Adds counts, coverage, worst cases, digits and witnesses. Precondition: both reports are of the same run.
void add_report(properties::GateReport& sum, const properties::GateReport& part);

/// Makes the sum a report of `shard`, which consists of the added shards: draws its sample, and states if too few cases
/// were judged.
void complete_sum(properties::GateReport& sum, const properties::Shard& shard);

}  // namespace carom::report
