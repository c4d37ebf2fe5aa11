// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate_result.hpp>
#include <carom/report/model/comparison.hpp>

/// The results of a run of the gate: one value. report.json holds it (run_json.hpp), and all forms of a report show it.
namespace carom::report {

/// Where and with what a run was made: what a reader needs to run it again. Empty where the system does not say.
struct Environment {
  std::string date;  // UTC, as ISO 8601 writes it
  std::string compiler;
  std::map<std::string, std::string> compiler_flags;  // by library: what all of its compile lines have
  std::string build_type;
  std::string operating_system;
  std::string kernel;
  std::string processor;
  unsigned processor_threads = 0;
};

/// The settings of a run.
struct Settings {
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> cases;    // of each family; none if a budget decided
  std::optional<double> budget_seconds;  // in place of `cases`
  oracles::Yardstick yardstick;
  bool fail_fast = false;
  std::uint64_t relations_every = 0;  // 0: as GateOptions says
  std::vector<std::string> deviates;  // what the command line has no subject claim
  std::optional<properties::Shard> shard;
};

struct RunFamily {
  std::string name;
  std::string summary;
  properties::Coverage coverage;
  std::vector<properties::SampledCase> sampled;  // as GateReport has them; no report.json holds them
};

struct FamilyBeyondDomain {
  std::string name;
  std::string summary;
  std::string quantity;  // of which it has much
};

/// Features of the colliding cases of all families.
struct Features {
  std::uint64_t feasible_pairs = 0;
  std::vector<std::pair<std::string, std::string>> missing_pairs;
  std::map<std::string, std::uint64_t> cases;  // by feature
};

/// An entry of report.json for a witness, which is a file of its own.
struct Violation {
  std::string invariant;
  std::uint64_t count = 0;  // cases that violate it
  std::string family;       // and case of the witness
  std::uint64_t index = 0;
  std::string witness;  // its file, relative to the report's directory
};

/// A subject that was judged, or was to be.
struct JudgedSubject {
  properties::SubjectResult result;  // families as in the run
  bool counts = false;               // towards the exit status
  /// "violated"; else "error" if it was not judged to the end, "not judged" if too little could be posed to it; else
  /// "sound".
  std::string status;
  properties::SubjectResult::WorstFamily worst;
  Digits digits;
  std::vector<Violation> violations;
  /// Invariants of the collision matrix, if the subject shows none; none in reports that do not list them.
  std::optional<std::vector<std::string>> not_claimed;
  std::optional<properties::diagnosis::Diagnosis> diagnosis;  // of one that violates something

  /// Why it was not judged, or not to the end; empty for others.
  [[nodiscard]] const std::string& why_not_judged() const {
    return result.error.empty() ? result.not_judged : result.error;
  }
};

struct Run {
  std::string carom;  // its version
  Environment environment;
  Settings settings;
  bool interrupted = false;
  std::vector<RunFamily> families;
  std::vector<FamilyBeyondDomain> beyond_domain;
  Features features;
  std::vector<JudgedSubject> subjects;
  std::vector<Subject> absent;           // asked for, or part of the default, and not installed
  std::optional<Comparison> baseline{};  // of this run with an earlier one

  /// 2 something that counts could not be judged at all, nothing counts, or the run was interrupted; else 1 something
  /// is violated or could not be judged to the end; 0 all hold. With a baseline, what is known from it is not counted.
  [[nodiscard]] int exit_status() const;
};

/// The value of what the gate found. `counts`: of each result, whether it counts. `is_shard`: whether the run is to be
/// merged with others. The diagnoses are made here.
[[nodiscard]] Run run_of(properties::GateReport report, const std::vector<bool>& counts, std::vector<Subject> absent,
                         Environment environment, std::vector<std::string> deviates, bool is_shard);

/// The invariants that a subject does not claim as it shows no collision matrix.
[[nodiscard]] std::vector<std::string> not_claimed_by(const Subject& subject);

/// The reason for that.
inline constexpr const char* shows_no_matrix = "as it shows no collision matrix";

/// The sum of a run over the subjects that count.
struct Overall {
  std::size_t subjects = 0;
  std::size_t sound = 0;
  std::size_t violated = 0;            // invariants, each counted once for each subject that violates it
  std::size_t violating_subjects = 0;  // those that violate any
  bool interrupted = false;
};

[[nodiscard]] Overall overall_of(const Run& run);

/// "sound", "3 violated" or "not judged". A violation is told also if something was not judged.
[[nodiscard]] std::string in_words(const Overall& overall);

/// A subject's name as part of a file's.
[[nodiscard]] std::string file_name_of(std::string name);

/// The file of a witness: DIRECTORY/witnesses/SUBJECT.INVARIANT.json.
[[nodiscard]] std::string witness_path(const std::string& directory, const Subject& subject,
                                       const std::string& invariant);

/// The command for a POSIX shell that replays the witness in that file with the same verdict.
[[nodiscard]] std::string replay_command(const std::string& witness_file, const Subject& subject,
                                         const oracles::Yardstick& yardstick);

/// The witnesses of a subject, the one that tells most first.
[[nodiscard]] std::vector<const properties::Witness*> witnesses_by_telling(const JudgedSubject& subject);

}  // namespace carom::report
