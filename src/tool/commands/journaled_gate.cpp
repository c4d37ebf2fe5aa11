// SPDX-License-Identifier: BSL-1.0
#include "commands/journaled_gate.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/report/model/report_sum.hpp>

namespace carom::tool {
namespace {

using properties::GateOptions;
using properties::GateReport;

std::uint64_t all_cases(const GateOptions& options) {
  std::uint64_t all = 0;
  for (const properties::Family* family : options.families) {
    all += cases_of(options, *family);
  }
  return all;
}

/// Progress in the whole shard, after `before` cases.
std::function<void(std::uint64_t, std::uint64_t)> progress_after(std::uint64_t before, const GateOptions& options) {
  if (!options.progress) {
    return {};
  }
  return [before, all = all_cases(options), report = options.progress](std::uint64_t done, std::uint64_t) {
    report(before + done, all);
  };
}

}  // namespace

std::uint64_t parts_of(const GateOptions& options) {
  constexpr std::uint64_t cases_of_part = 1000;
  constexpr std::uint64_t most_parts = 1000;
  return std::clamp<std::uint64_t>(options.cases / options.shard.of / cases_of_part, 1, most_parts);
}

GateReport journaled_gate(const std::vector<Subject>& subjects, const GateOptions& options, const Journal& journal,
                          const std::function<report::Run(GateReport)>& as_run) {
  CAROM_EXPECTS(!options.budget && !options.fail_fast);
  const std::uint64_t parts = parts_of(options);
  std::optional<GateReport> sum;
  std::uint64_t already_finished = 0;
  std::uint64_t before = 0;
  const auto is_over = [&] { return sum && (options.stop.stop_requested() || sum->judge_error); };
  for (std::uint64_t i = 1; i <= parts && !is_over(); ++i) {
    GateOptions of_part = options;
    of_part.shard = options.shard.part(i, parts);
    of_part.shrinks = false;
    of_part.progress = progress_after(before, options);
    std::optional<GateReport> part = journal.finished(of_part.shard);
    if (part) {
      ++already_finished;
    } else {
      part = run_gate(subjects, of_part);
      if (!part->interrupted && !part->judge_error) {
        for (properties::SubjectResult& result : part->results) {
          result.witnesses.clear();  // the worst violations suffice to find them again
        }
        journal.keep(as_run(std::move(*part)));
        part = journal.finished(of_part.shard);
      }
    }
    before += all_cases(of_part);
    if (sum) {
      report::add_report(*sum, *part);
    } else {
      sum = std::move(part);
    }
  }
  if (already_finished > 0) {
    fmt::print(stderr, "carom: {} of {} parts are in the journal, and are not judged again\n", already_finished, parts);
  }
  report::complete_run(*sum, options, subjects);
  return std::move(*sum);
}

}  // namespace carom::tool
