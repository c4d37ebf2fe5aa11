// SPDX-License-Identifier: BSL-1.0
#include "io/job_shard.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include <carom/report/results/words.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

using properties::Shard;

/// A run has at most this many shards.
inline constexpr std::uint64_t most_shards = 1'000'000;

/// The number that the text is, in decimal digits only; none if it is no number of 64 bits.
std::optional<std::uint64_t> number_from(std::string_view digits) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_number = error == std::errc() && end == digits.data() + digits.size();
  return is_number ? std::optional(number) : std::nullopt;
}

/// A system that numbers processes from `first` on.
struct Numbering {
  const char* system;
  const char* index;     // the variable with the number of this process
  const char* count;     // the variable with the number of processes
  const char* presence;  // the variable that only this system sets
  std::uint64_t first;
  const char* source;  // of the variables, for messages
};

constexpr std::array job_numberings{
    Numbering{"Kubernetes", "JOB_COMPLETION_INDEX", "JOB_COMPLETIONS", "JOB_COMPLETION_INDEX", 0,
              "set JOB_COMPLETIONS to the job's spec.completions"},
    Numbering{"GitHub", "STRATEGY_JOB_INDEX", "STRATEGY_JOB_TOTAL", "STRATEGY_JOB_INDEX", 0,
              "set both variables to strategy.job-index and strategy.job-total"},
    Numbering{"GitLab", "CI_NODE_INDEX", "CI_NODE_TOTAL", "CI_NODE_INDEX", 1, "GitLab sets both variables"},
};
constexpr Numbering rank_numbering{
    "Open MPI", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK", 0, "mpirun sets both variables",
};
// Slurm sets SLURM_PROCID also outside a step.
constexpr Numbering step_numbering{
    "a Slurm step", "SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "SLURM_STEP_NUM_TASKS", 0, "srun sets both variables",
};
constexpr const char* array_index = "SLURM_ARRAY_TASK_ID";
constexpr const char* array_count = "SLURM_ARRAY_TASK_COUNT";
constexpr const char* array_source = "Slurm sets it for each task of an array";

[[noreturn]] void fail_auto(const std::string& what) { throw UsageError("--shard auto: " + what); }

/// The number in a variable. Throws UsageError that ends with `source` if the variable has none.
std::uint64_t number_in(const VariableLookup& value_of, const char* variable, const char* source) {
  const std::optional<std::string> text = value_of(variable);
  if (!text) {
    fail_auto(fmt::format("{} is not set; {}", variable, source));
  }
  const std::optional<std::uint64_t> number = number_from(*text);
  if (!number) {
    fail_auto(
        fmt::format("{} is '{}'; expected a number in decimal digits; {}", variable, report::shown(*text), source));
  }
  return *number;
}

void require_shards(const char* variable, std::uint64_t count, const char* source) {
  if (count < 1 || count > most_shards) {
    fail_auto(fmt::format("{} is {}; expected a number from 1 to {}; {}", variable, count, most_shards, source));
  }
}

Shard shard_by(const Numbering& numbering, const VariableLookup& value_of) {
  const std::uint64_t index = number_in(value_of, numbering.index, numbering.source);
  const std::uint64_t count = number_in(value_of, numbering.count, numbering.source);
  require_shards(numbering.count, count, numbering.source);
  if (index < numbering.first || index - numbering.first >= count) {
    fail_auto(fmt::format("{} is {}; expected a number from {} to {}, because {} is {}; {}", numbering.index, index,
                          numbering.first, count - 1 + numbering.first, numbering.count, count, numbering.source));
  }
  return {index - numbering.first + 1, count};
}

/// The task numbers of an array are MIN, MIN + STEP, …, MAX. Slurm gives no list of other numbers.
Shard shard_by_array(const VariableLookup& value_of) {
  const auto number = [&](const char* variable) { return number_in(value_of, variable, array_source); };
  const std::uint64_t index = number(array_index);
  const std::uint64_t count = number(array_count);
  const std::uint64_t min = number("SLURM_ARRAY_TASK_MIN");
  const std::uint64_t max = number("SLURM_ARRAY_TASK_MAX");
  require_shards(array_count, count, array_source);
  const std::string range = fmt::format("SLURM_ARRAY_TASK_MIN is {} and SLURM_ARRAY_TASK_MAX is {}", min, max);
  if (index < min || index > max) {
    fail_auto(
        fmt::format("{} is {}; expected a number from {} to {}, because {}", array_index, index, min, max, range));
  }
  if (count == 1 ? max > min : (max - min) % (count - 1) != 0 || max == min) {
    fail_auto(fmt::format("{} is {}, but {}; expected an array with equal steps, such as --array=1-100", array_count,
                          count, range));
  }
  const std::uint64_t between = count == 1 ? 1 : (max - min) / (count - 1);
  if ((index - min) % between != 0) {
    fail_auto(fmt::format("{} is {}, but {} and {} is {}; expected an array with equal steps, such as --array=1-100",
                          array_index, index, range, array_count, count));
  }
  return {(index - min) / between + 1, count};
}

struct Found {
  const char* variable;
  Shard shard;
};

std::optional<Shard> shard_among_jobs(const VariableLookup& value_of) {
  std::vector<Found> found;
  if (value_of(array_index)) {
    found.push_back({array_index, shard_by_array(value_of)});
  }
  for (const Numbering& numbering : job_numberings) {
    if (value_of(numbering.presence)) {
      found.push_back({numbering.presence, shard_by(numbering, value_of)});
    }
  }
  if (found.size() > 1) {
    fail_auto(
        fmt::format("both {} and {} are set, so it is unclear which system numbers the jobs; unset one of them, or "
                    "use --shard I/N",
                    found[0].variable, found[1].variable));
  }
  return found.empty() ? std::nullopt : std::optional(found[0].shard);
}

std::optional<Shard> shard_in_job(const VariableLookup& value_of) {
  for (const Numbering* numbering : {&rank_numbering, &step_numbering}) {
    if (value_of(numbering->presence)) {
      return shard_by(*numbering, value_of);
    }
  }
  return std::nullopt;
}

[[noreturn]] void fail_without_system() {
  std::string looked_for = fmt::format("{} (a Slurm array)", array_index);
  for (const Numbering* numbering : {&step_numbering, &rank_numbering, &job_numberings[0], &job_numberings[1]}) {
    looked_for += fmt::format(", {} ({})", numbering->presence, numbering->system);
  }
  fail_auto(
      fmt::format("the environment has no variable of a batch system; expected one of {} or {} ({}); elsewhere, use "
                  "--shard I/N",
                  looked_for, job_numberings[2].presence, job_numberings[2].system));
}

}  // namespace

std::optional<properties::Shard> shard_from(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::optional<std::uint64_t> number = number_from(text.substr(0, slash));
  const std::optional<std::uint64_t> of = slash < text.size() ? number_from(text.substr(slash + 1)) : std::nullopt;
  const bool is_shard = number && of && *number >= 1 && *number <= *of && *of <= most_shards;
  return is_shard ? std::optional(properties::Shard{*number, *of}) : std::nullopt;
}

std::string is_shard(const std::string& text) {
  const bool is_one = text == automatic_shard || shard_from(text).has_value();
  return is_one ? "" : fmt::format("expected I/N with I from 1 to N and N at most {}, or auto", most_shards);
}

std::string folder_of(const properties::Shard& shard) { return fmt::format("shard-{}-of-{}", shard.number, shard.of); }

std::optional<std::string> variable_of_process(const std::string& variable) {
  const char* value = std::getenv(variable.c_str());
  return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

Shard shard_of_job(const VariableLookup& value_of) {
  const std::optional<Shard> job = shard_among_jobs(value_of);
  const std::optional<Shard> process = shard_in_job(value_of);
  if (!job && !process) {
    fail_without_system();
  }
  const Shard outer = job.value_or(Shard{});
  const Shard inner = process.value_or(Shard{});
  const Shard shard{(outer.number - 1) * inner.of + inner.number, outer.of * inner.of};
  if (shard.of > most_shards) {
    fail_auto(fmt::format("{} jobs with {} processes each are too many shards; expected at most {}", outer.of, inner.of,
                          most_shards));
  }
  return shard;
}

}  // namespace carom::tool
