// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::tool {

/// The value of an environment variable; none if it is not set.
using VariableLookup = std::function<std::optional<std::string>(const std::string& variable)>;

/// The environment of this process.
[[nodiscard]] std::optional<std::string> variable_of_process(const std::string& variable);

/// The shard of this process among all processes of a batch job. Two levels number the processes:
///   (1) the jobs: a Slurm array, an indexed job of Kubernetes, or parallel jobs of GitHub or GitLab;
///   (2) the processes in each job: ranks of Open MPI, or tasks of a Slurm step. Ranks win, because mpirun starts its
///       own daemons as tasks of a step.
/// If both levels are present, each process of each job has its own shard. Throws UsageError if no level is present, if
/// two systems number the jobs, or if a variable is not set, is no number, or is outside its range. The message names
/// the variable and its value.
[[nodiscard]] properties::Shard shard_of_job(const VariableLookup& value_of);

}  // namespace carom::tool
