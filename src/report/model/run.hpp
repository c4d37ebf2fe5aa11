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
#include <carom/properties/gate/gate_report.hpp>
#include <carom/report/model/comparison.hpp>
#include <carom/report/model/subject_status.hpp>

/// The results of a run of the gate, as one value. report.json contains it (run_json.hpp), and all forms of a report
/// show it.
namespace carom::report {

/// The environment of a run, which a reader needs to repeat it. A field is empty if the system does not provide it.
struct Environment {
  std::string date;  // UTC, in ISO 8601
  std::string compiler;
  std::map<std::string, std::string> compiler_flags;  // by library: the flags of all its compile lines
  std::string build_type;
  std::string operating_system;
  std::string kernel;
  std::string processor;
  unsigned processor_threads = 0;
};

struct Settings {
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> cases;                        // of each family; none if a time budget decides the number
  std::optional<double> budget_seconds;                      // in place of `cases`
  properties::Domain within = {};                            // of the cases
  std::vector<const properties::Family*> without_case = {};  // have no case within the domain, so none was posed
  oracles::Limits limits;
  bool fail_fast = false;
  std::uint64_t relations_every = 0;  // 0: the default of GateOptions
  std::vector<std::string> deviates;  // deviations from the command line, which apply to every subject
  std::optional<properties::Shard> shard;
};

struct RunFamily {
  const properties::Family* family = nullptr;
  properties::Coverage coverage;
  std::vector<properties::SampledCase> sampled;  // as in GateReport; report.json does not contain them
};

/// The features (special values or relations) of the colliding cases of all families.
struct Features {
  std::uint64_t met_pairs = 0;                 // pairs of features that some case has
  std::map<std::string, std::uint64_t> cases;  // by feature
  std::string pairs;                           // as in FeatureCoverage; only the report of a shard contains them
};

/// A violated invariant of a subject, as report.json lists it. Its witness is a separate file.
struct Violation {
  const properties::Invariant* invariant = nullptr;
  std::uint64_t count = 0;                     // cases that violate it
  const properties::Family* family = nullptr;  // family and case of the witness
  std::uint64_t index = 0;
  std::string witness;  // its file, relative to the report's directory
};

/// A subject (a solver under test) that was judged, or should have been.
struct JudgedSubject {
  properties::SubjectResult result;  // its families are those of the run, in the same order
  bool counts = false;               // whether its violations decide the exit status
  SubjectStatus status = SubjectStatus::sound;
  properties::SubjectResult::WorstFamily worst;
  Digits digits;
  std::vector<Violation> violations;
  std::vector<const properties::Invariant*> never_judged = {};  // claimed; empty after an error
  std::optional<properties::diagnosis::Diagnosis> diagnosis;    // of a subject with a violation
  std::string no_diagnosis = {};  // why the diagnosis of a subject with a violation is missing; empty if it is not

  /// The reason why the subject was not judged, or not to the end; otherwise empty.
  [[nodiscard]] const std::string& why_not_judged() const {
    return result.error.empty() ? result.not_judged : result.error;
  }
};

struct Run {
  std::string carom;  // its version
  Environment environment;
  Settings settings;
  bool interrupted = false;
  std::optional<oracles::JudgeError> judge_error = {};  // the fault of the judge that ended the run
  std::vector<RunFamily> families;
  std::vector<const properties::Family*> beyond_domain;
  Features features;
  std::vector<JudgedSubject> subjects;
  std::vector<Subject> absent;           // chosen by the command line or by default, but not installed
  std::optional<Comparison> baseline{};  // of this run with an earlier one

  /// 2 if a subject that counts could not be judged at all, if no subject counts, if the run was interrupted, or if
  /// the judge failed.
  /// Otherwise 1 if a subject that counts violates an invariant or could not be judged to the end. Otherwise 0. With a
  /// baseline, known violations do not count.
  [[nodiscard]] int exit_status() const;
};

/// Makes a Run from the gate's results. `counts` tells for each result if its subject decides the exit status.
/// `is_shard` tells if the run will be merged with others. `is_diagnosed` tells if it has diagnoses, which take time.
[[nodiscard]] Run run_of(properties::GateReport report, const std::vector<bool>& counts, std::vector<Subject> absent,
                         Environment environment, std::vector<std::string> deviates, bool is_shard,
                         bool is_diagnosed = true);

/// The reason why properties::not_claimed_without_matrix lists an invariant, in words.
inline constexpr const char* shows_no_matrix = "because it shows no collision matrix";

[[nodiscard]] Overall overall_of(const Run& run);

/// A subject's name, as a part of a file's name.
[[nodiscard]] std::string file_name_of(std::string name);

/// The file of a witness: DIRECTORY/witnesses/SUBJECT.INVARIANT.json.
[[nodiscard]] std::string witness_path(const std::string& directory, const Subject& subject,
                                       const properties::Invariant& invariant);

/// The POSIX shell command that replays the witness in `witness_file` with the same verdict.
[[nodiscard]] std::string replay_command(const std::string& witness_file, const Subject& subject,
                                         const oracles::Limits& limits);

/// The POSIX shell command that draws the case of a fault again, with the same verdict.
[[nodiscard]] std::string replay_command(const properties::diagnosis::FaultWitness& witness, const Settings& settings,
                                         const Subject& subject);

/// The witnesses of a subject. The witness of the invariant `Diagnosis::telling` is first.
[[nodiscard]] std::vector<const properties::Witness*> witnesses_by_telling(const JudgedSubject& subject);

}  // namespace carom::report
