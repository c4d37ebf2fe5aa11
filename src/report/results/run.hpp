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
#include <carom/report/results/comparison.hpp>
#include <carom/report/results/version.hpp>

/// The results of a run of the gate, as one value. report.json contains it (run_json.hpp), and all forms of a report
/// show it.
namespace carom::report {

inline constexpr int exit_all_hold = 0;
inline constexpr int exit_violated = 1;
inline constexpr int exit_usage = 2;  // usage, environment, or input that cannot be read

/// The text for a missing number.
inline constexpr const char* no_number = "–";

/// The numbers of correct digits that 50 %, 99 % and 100 % of the cases reach. None if no digits were measured.
struct Digits {
  std::optional<double> p50;
  std::optional<double> p99;
  std::optional<double> worst;
};

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

/// The gate's results, with what else a report knows.
struct Run : properties::GateReport {
  Environment environment;
  std::vector<std::string> deviates;                    // from the command line; they apply to every subject
  std::vector<const properties::Family*> without_case;  // have no case within the domain, so none was posed
  std::vector<bool> counts;                             // of each result: whether it decides the exit status
  std::vector<Subject> absent;                          // chosen by the command line or by default, not installed
  bool is_shard = false;                                // whether the run will be merged with others
  // Of each result. `telling` is nullptr if there is no diagnosis.
  std::vector<properties::diagnosis::Diagnosis> diagnoses = {};
  std::string carom = version;
  std::optional<Comparison> baseline = {};  // of this run with an earlier one

  /// 2 if a subject that counts could not be judged at all, if no subject counts, if the run was interrupted, or if
  /// the judge failed.
  /// Otherwise 1 if a subject that counts violates an invariant or could not be judged to the end. Otherwise 0. With a
  /// baseline, known violations do not count.
  [[nodiscard]] int exit_status() const;
};

/// The run with a diagnosis of each subject that violates an invariant. This takes time.
[[nodiscard]] Run diagnosed(Run run);

[[nodiscard]] SubjectStatus status_of(const properties::SubjectResult& result);

[[nodiscard]] Digits digits_of(const properties::SubjectResult& result);

/// The reason why the subject was not judged, or not to the end; otherwise empty.
[[nodiscard]] const std::string& why_not_judged(const properties::SubjectResult& result);

/// The claimed invariants that no case judged. Empty if the subject was not judged to the end.
[[nodiscard]] std::vector<const properties::Invariant*> never_judged(const Run& run,
                                                                     const properties::SubjectResult& result);

/// The reason why properties::not_claimed_without_matrix lists an invariant, in words.
inline constexpr const char* shows_no_matrix = "because it shows no collision matrix";

/// The totals of a run over the subjects that count.
struct Overall {
  std::size_t subjects = 0;
  std::size_t sound = 0;
  std::size_t violated = 0;            // invariants, each counted once for each subject that violates it
  std::size_t violating_subjects = 0;  // subjects with any violation
  bool interrupted = false;
};

[[nodiscard]] Overall overall_of(const Run& run);

/// Whether the run ended, and found every subject sound.
[[nodiscard]] bool is_sound_throughout(const Overall& overall);

/// "sound", "3 violated" or "not judged". Violations are reported even if something was not judged.
[[nodiscard]] std::string in_words(const Overall& overall);

/// A subject's name, as a part of a file's name.
[[nodiscard]] std::string file_name_of(std::string name);

/// The file of a witness: DIRECTORY/witnesses/SUBJECT.INVARIANT.json.
[[nodiscard]] std::string witness_path(const std::string& directory, const Subject& subject,
                                       const properties::Invariant& invariant);

/// The POSIX shell command that replays the witness in `witness_file` with the same verdict.
[[nodiscard]] std::string replay_command(const std::string& witness_file, const Subject& subject,
                                         const properties::GateOptions& options);

/// The POSIX shell command that draws the case of a fault again, with the same verdict.
[[nodiscard]] std::string replay_command(const properties::diagnosis::FaultWitness& witness,
                                         const properties::GateOptions& options, const Subject& subject);

/// The witnesses of the subject at this place. The witness of the invariant `Diagnosis::telling` is first.
[[nodiscard]] std::vector<const properties::Witness*> witnesses_by_telling(const Run& run, std::size_t s);

}  // namespace carom::report
