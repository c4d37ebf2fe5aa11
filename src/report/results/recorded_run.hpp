// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/properties/gate/family_result.hpp>
#include <carom/report/results/digits.hpp>
#include <carom/report/results/subject_status.hpp>

/// A report of any version of Carom, as comparisons read it. Families and invariants are names,
/// because this program may not know them. Every text is a line that is safe to print.
namespace carom::report {

struct RunHeading {
  std::string file;
  std::string carom;  // its version
  std::string date;
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> cases;  // of each family; none if a time budget decided the number
  std::size_t families = 0;
  std::string shard;  // "2/3"; empty for a whole run
};

/// A subject in one line.
struct SubjectSummary {
  SubjectStatus status = SubjectStatus::sound;
  std::string error;    // the reason why it was not judged to the end
  std::string version;  // empty if it states none
  std::string law;
  std::string precision;
  std::uint64_t cases = 0;
  std::uint64_t violated_cases = 0;            // cases that violated any invariant
  std::vector<std::string> violated;           // invariants
  std::optional<double> worst_backward_error;  // ulps; none if the law determines no outcome
  std::string worst_family;                    // empty if there is none
  Digits digits;
  std::vector<std::string> deviates;  // "invariant" or "invariant@family"
};

struct RecordedFamily {
  std::string name;
  std::uint64_t violated = 0;                       // cases that violated any invariant
  std::map<std::string, properties::Count> counts;  // by invariant; without the skipped cases
};

struct RecordedSubject {
  std::string name;
  std::string specification;  // on the command line; empty for a built-in subject
  bool counts = false;        // whether its violations decide the exit status
  SubjectSummary summary;
  std::string effects;  // the declared effects in words
  /// The invariants that it does not claim because it shows no collision matrix. None if the report does not list them.
  std::optional<std::vector<std::string>> not_claimed;
  std::vector<RecordedFamily> families;  // empty for an absent subject
};

struct RecordedRun {
  RunHeading heading;
  bool interrupted = false;
  std::vector<std::string> families;
  std::vector<RecordedSubject> subjects;  // the absent ones last
  // Settings in words.
  std::string cases;
  std::string domain;
  std::string yardstick;
  std::string relations_every;
  std::string ended_early;
};

/// Reads a report. Fields that it does not need may be missing. Throws FormatError that names the place if a field is
/// missing or has another type, or if a subject or a family occurs twice.
[[nodiscard]] RecordedRun recorded_run(const nlohmann::json& record, const std::string& file);

/// The totals of a run over the subjects that count.
struct Overall {
  std::size_t subjects = 0;
  std::size_t sound = 0;
  std::size_t violated = 0;            // invariants, each counted once for each subject that violates it
  std::size_t violating_subjects = 0;  // subjects with any violation
  bool interrupted = false;

  void add(SubjectStatus status, std::size_t violated_invariants);
};

[[nodiscard]] Overall overall_of(const RecordedRun& run);

/// Whether the run ended, and found every subject sound.
[[nodiscard]] bool is_sound_throughout(const Overall& overall);

/// "sound", "3 violated" or "not judged". Violations are reported even if something was not
/// judged.
[[nodiscard]] std::string in_words(const Overall& overall);

}  // namespace carom::report
