// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>
#include <carom/report/results/run_json.hpp>

/// The sum of the reports of several shards.
namespace carom::report {

/// Adds counts, coverage, worst cases, digits and witnesses, in the order of the shards. Precondition: both reports are
/// of the same run.
void add_report(properties::GateReport& sum, const properties::GateReport& part);

/// Completes the sum of all parts of the run that `options` describe: draws its sample, states if too few cases were
/// judged, and finds its witnesses. Preconditions:
/// `options` have no budget, and are not `fail_fast`; `subjects` are those of the parts, and open sessions.
void complete_run(properties::GateReport& sum, const properties::GateOptions& options,
                  const std::vector<Subject>& subjects);

/// Thrown if the shards are not exactly those of one run. A shard holds every n-th case of each family.
class MergeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The run that consists of the shards. Its counts, coverage, worst backward errors and cases, digits and sample are
/// those of a run without shards. For each invariant, it has one witness: the worst witness of the shards from the
/// family with the most violations. The time of a solve is the mean over the shards, weighted by their cases. The date
/// and the machine are those of the first shard. Throws MergeError that says what differs if the shards do not belong
/// together, if one is missing, or if one occurs twice.
[[nodiscard]] Run merged_run(const std::vector<ReadShard>& shards);

}  // namespace carom::report
