// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cctype>
#include <chrono>

#include <fmt/format.h>

#include <carom/collision/json/text.hpp>
#include <carom/report/model/exit_status.hpp>
#include <carom/report/model/run.hpp>
#include <carom/report/model/version.hpp>
#include <carom/report/model/words.hpp>

namespace carom::report {
namespace {

using properties::GateOptions;
using properties::SubjectResult;

SubjectStatus status_of(const SubjectResult& result) {
  if (!result.violated_invariants().empty()) {
    return SubjectStatus::violated;
  }
  if (!result.error.empty()) {
    return SubjectStatus::error;
  }
  return result.is_sound() ? SubjectStatus::sound : SubjectStatus::not_judged;
}

Settings settings_of(const GateOptions& options, std::vector<std::string> deviates, bool is_shard) {
  Settings settings;
  settings.seed = options.seed;
  if (options.budget) {
    settings.budget_seconds = std::chrono::duration<double>(*options.budget).count();
  } else {
    settings.cases = options.cases;
  }
  settings.within = options.within;
  settings.limits = options.limits;
  settings.fail_fast = options.fail_fast;
  settings.relations_every = options.relations_every;
  settings.deviates = std::move(deviates);
  if (is_shard) {
    settings.shard = options.shard;
  }
  return settings;
}

Features features_of(const properties::FeatureCoverage& coverage) {
  Features features;
  features.met_pairs = coverage.met_pairs();
  features.pairs = coverage.pairs();
  for (std::size_t i = 0; i < properties::all_features().size(); ++i) {
    features.cases[std::string(properties::all_features()[i].name)] = coverage.count(i);
  }
  return features;
}

JudgedSubject judged_subject(SubjectResult result, const GateOptions& options, bool counts) {
  JudgedSubject subject;
  subject.counts = counts;
  subject.status = status_of(result);
  subject.worst = result.worst_backward_error(options);
  subject.digits = {result.digits_at_least(0.5), result.digits_at_least(0.99), result.digits_at_least(1)};
  for (const properties::Witness& witness : result.witnesses) {
    subject.violations.push_back({witness.invariant, result.count(*witness.invariant).violated, witness.family,
                                  witness.index, witness_path("", result.subject, *witness.invariant)});
  }
  if (subject.status != SubjectStatus::error) {
    subject.never_judged = result.never_judged(options);
  }
  subject.result = std::move(result);
  return subject;
}

}  // namespace

Run run_of(properties::GateReport report, const std::vector<bool>& counts, std::vector<Subject> absent,
           Environment environment, std::vector<std::string> deviates, bool is_shard, bool is_diagnosed) {
  std::vector<properties::diagnosis::Diagnosis> diagnoses(report.results.size());
  if (is_diagnosed) {
    diagnoses = properties::diagnosis::diagnose_all(report);
  }
  const GateOptions& options = report.options;
  Run run;
  run.carom = version;
  run.environment = std::move(environment);
  run.settings = settings_of(options, std::move(deviates), is_shard);
  run.interrupted = report.interrupted;
  run.judge_error = report.judge_error;
  for (std::size_t f = 0; f < options.families.size(); ++f) {
    run.families.push_back(
        {options.families[f], report.coverage[f],
         f < report.sampled.size() ? std::move(report.sampled[f]) : std::vector<properties::SampledCase>()});
  }
  run.beyond_domain = options.beyond_domain;
  run.features = features_of(report.features);
  for (std::size_t s = 0; s < report.results.size(); ++s) {
    run.subjects.push_back(judged_subject(std::move(report.results[s]), options, counts[s]));
    if (diagnoses[s].telling != nullptr) {
      run.subjects.back().diagnosis = diagnoses[s];
    }
    run.subjects.back().no_diagnosis = diagnoses[s].missing;
  }
  run.absent = std::move(absent);
  return run;
}

int Run::exit_status() const {
  bool judged = false;
  bool violated = false;
  bool ended_early = false;
  bool failed = interrupted || judge_error;
  for (const JudgedSubject& subject : subjects) {
    if (!subject.counts) {
      continue;
    }
    judged = true;
    // A subject that was judged, but not to the end, is itself at fault.
    const bool is_at_fault = subject.status == SubjectStatus::violated ||
                             (subject.status == SubjectStatus::error && subject.result.cases() > 0);
    violated = violated || is_at_fault;
    ended_early = ended_early || !subject.result.error.empty();
    failed = failed || (subject.status != SubjectStatus::sound && !is_at_fault);
  }
  if (failed || !judged) {
    return exit_usage;
  }
  const bool is_new = baseline ? ended_early || baseline->count_new(true) > 0 : violated;
  return is_new ? exit_violated : exit_all_hold;
}

void Overall::add(SubjectStatus status, std::size_t violated_invariants) {
  ++subjects;
  sound += status == SubjectStatus::sound ? 1 : 0;
  violated += violated_invariants;
  violating_subjects += status == SubjectStatus::violated ? 1 : 0;
}

Overall overall_of(const RecordedRun& run) {
  Overall overall;
  overall.interrupted = run.interrupted;
  for (const RecordedSubject& subject : run.subjects) {
    if (subject.counts) {
      overall.add(subject.summary.status, subject.summary.violated.size());
    }
  }
  return overall;
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
  for (const JudgedSubject& subject : run.subjects) {
    if (subject.counts) {
      overall.add(subject.status, subject.violations.size());
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

std::string replay_command(const std::string& witness_file, const Subject& subject, const oracles::Limits& limits) {
  return fmt::format("carom replay {}", quoted(witness_file)) + replay_options(subject, limits);
}

std::string replay_command(const properties::diagnosis::FaultWitness& witness, const Settings& settings,
                           const Subject& subject) {
  return fmt::format("carom replay --family {} --case {} --seed {}{}", witness.family->name, witness.index,
                     settings.seed, within_option(settings.within)) +
         replay_options(subject, settings.limits);
}
std::vector<const properties::Witness*> witnesses_by_telling(const JudgedSubject& subject) {
  std::vector<const properties::Witness*> ordered;
  for (const properties::Witness& witness : subject.result.witnesses) {
    ordered.push_back(&witness);
  }
  std::stable_partition(ordered.begin(), ordered.end(), [&](const properties::Witness* witness) {
    return subject.diagnosis && witness->invariant == subject.diagnosis->telling;
  });
  return ordered;
}

}  // namespace carom::report
