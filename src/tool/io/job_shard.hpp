// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::tool {

/// The argument of --shard that takes the shard from the batch system.
inline constexpr std::string_view automatic_shard = "auto";

/// Parses "2/3". None if the text is not I/N with 1 ≤ I ≤ N ≤ 1,000,000.
[[nodiscard]] std::optional<properties::Shard> shard_from(std::string_view text);

/// The error message if the text is neither automatic_shard nor I/N; empty if it is one of them.
[[nodiscard]] std::string is_shard(const std::string& text);

/// "shard-2-of-3", the folder of a shard's reports.
[[nodiscard]] std::string folder_of(const properties::Shard& shard);

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
