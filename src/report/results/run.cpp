// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include <carom/collision/json/text.hpp>
#include <carom/report/results/run.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {

using properties::SubjectResult;

Run diagnosed(Run run) {
  run.diagnoses = properties::diagnosis::diagnose_all(run);
  return run;
}

SubjectStatus status_of(const SubjectResult& result) {
  if (!result.violated_invariants().empty()) {
    return SubjectStatus::violated;
  }
  if (!result.error.empty()) {
    return SubjectStatus::error;
  }
  return result.is_sound() ? SubjectStatus::sound : SubjectStatus::not_judged;
}

Digits digits_of(const SubjectResult& result) {
  return {result.digits_at_least(0.5), result.digits_at_least(0.99), result.digits_at_least(1)};
}

const std::string& why_not_judged(const SubjectResult& result) {
  return result.error.empty() ? result.not_judged : result.error;
}

std::vector<const properties::Invariant*> never_judged(const Run& run, const SubjectResult& result) {
  return status_of(result) == SubjectStatus::error ? std::vector<const properties::Invariant*>()
                                                   : result.never_judged(run.options);
}

int Run::exit_status() const {
  bool judged = false;
  bool violated = false;
  bool ended_early = false;
  bool failed = interrupted || judge_error;
  for (std::size_t s = 0; s < results.size(); ++s) {
    if (!counts[s]) {
      continue;
    }
    judged = true;
    const SubjectStatus status = status_of(results[s]);
    // A subject that was judged, but not to the end, is itself at fault.
    const bool is_at_fault =
        status == SubjectStatus::violated || (status == SubjectStatus::error && results[s].cases() > 0);
    violated = violated || is_at_fault;
    ended_early = ended_early || !results[s].error.empty();
    failed = failed || (status != SubjectStatus::sound && !is_at_fault);
  }
  if (failed || !judged) {
    return exit_usage;
  }
  const bool is_new = baseline ? ended_early || baseline->count_new(true) > 0 : violated;
  return is_new ? exit_violated : exit_all_hold;
}

bool is_sound_throughout(const Overall& overall) {
  return overall.violated == 0 && overall.subjects > 0 && overall.sound == overall.subjects && !overall.interrupted;
}

std::string in_words(const Overall& overall) {
  if (overall.violated > 0) {
    return fmt::format("{} violated", overall.violated);
  }
  return is_sound_throughout(overall) ? "sound" : "not judged";
}

Overall overall_of(const Run& run) {
  Overall overall;
  overall.interrupted = run.interrupted;
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    if (run.counts[s]) {
      const SubjectStatus status = status_of(run.results[s]);
      ++overall.subjects;
      overall.sound += status == SubjectStatus::sound ? 1 : 0;
      overall.violated += run.results[s].witnesses.size();
      overall.violating_subjects += status == SubjectStatus::violated ? 1 : 0;
    }
  }
  return overall;
}

std::string file_name_of(std::string name) {
  for (char& letter : name) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' || letter == '.';
    letter = is_plain ? letter : '_';
  }
  return name;
}

std::string witness_path(const std::string& directory, const Subject& subject, const properties::Invariant& invariant) {
  const char* separator = directory.empty() || directory.back() == '/' ? "" : "/";
  return fmt::format("{}{}witnesses/{}.{}.json", directory, separator, file_name_of(subject.name), invariant.name);
}

namespace {

/// The options of a replay by which its verdict is the same.
std::string replay_options(const Subject& subject, const oracles::Limits& limits) {
  std::string command =
      fmt::format(" --subject {}", quoted(subject.specification.empty() ? subject.name : subject.specification));
  if (limits.limit_ulps != oracles::default_limit_ulps) {
    command += fmt::format(" --limit-ulps {}", limits.limit_ulps);
  }
  if (limits.digits) {
    command += fmt::format(" --digits {}", *limits.digits);
  }
  if (!limits.filtered) {
    command += " --exact";
  }
  return command;
}

}  // namespace

std::string replay_command(const std::string& witness_file, const Subject& subject,
                           const properties::GateOptions& options) {
  properties::Domain kinds;  // in which the related collisions lie
  kinds.kinds = options.within.kinds;
  return fmt::format("carom replay {}{}", quoted(witness_file), within_option(kinds)) +
         replay_options(subject, options.limits);
}

std::string replay_command(const properties::diagnosis::FaultWitness& witness, const properties::GateOptions& options,
                           const Subject& subject) {
  return fmt::format("carom replay --family {} --case {} --seed {}{}", witness.family->name, witness.index,
                     options.seed, within_option(options.within)) +
         replay_options(subject, options.limits);
}

std::vector<const properties::Witness*> witnesses_by_telling(const Run& run, std::size_t s) {
  std::vector<const properties::Witness*> ordered;
  for (const properties::Witness& witness : run.results[s].witnesses) {
    ordered.push_back(&witness);
  }
  std::stable_partition(ordered.begin(), ordered.end(), [&](const properties::Witness* witness) {
    return witness->invariant == run.diagnoses[s].telling;
  });
  return ordered;
}

}  // namespace carom::report
