// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/collision/enum_array.hpp>
#include <carom/properties/gate/family_result.hpp>

/// The differences between two reports. Every text is a line that is safe to print.
namespace carom::report {

/// The state of a subject after a run.
enum class SubjectStatus {
  sound,
  violated,    // it violates an invariant
  error,       // it was not judged to the end, and violates none
  not_judged,  // it got too few cases
  absent,      // it is not installed
};
inline constexpr std::array all_subject_statuses{SubjectStatus::sound, SubjectStatus::violated, SubjectStatus::error,
                                                 SubjectStatus::not_judged, SubjectStatus::absent};
static_assert(counts_from_zero_to(all_subject_statuses, SubjectStatus::absent));

[[nodiscard]] constexpr std::string_view name_of(SubjectStatus status) {
  constexpr EnumArray<SubjectStatus, std::string_view, all_subject_statuses.size()> names{"sound", "violated", "error",
                                                                                          "not judged", "absent"};
  return names[status];
}

struct RunHeading {
  std::string file;
  std::string carom;  // its version
  std::string date;
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> cases;  // of each family; none if a time budget decided the number
};

struct RecordedFamily {
  std::string name;
  std::map<std::string, properties::Count> counts;  // by invariant; without the skipped cases
};

struct RecordedSubject {
  std::string name;
  std::string specification;  // on the command line; empty for a built-in subject
  bool counts = false;        // whether its violations decide the exit status
  SubjectStatus status = SubjectStatus::sound;
  std::string error;                  // the reason why it was not judged to the end
  std::vector<std::string> violated;  // invariants
  std::vector<std::string> deviates;  // "invariant" or "invariant@family"
  std::string effects;                // the declared effects in words
  /// The invariants that it does not claim because it shows no collision matrix. None if the report does not list them.
  std::optional<std::vector<std::string>> not_claimed;
  std::vector<RecordedFamily> families;  // empty for an absent subject
};

/// A report of any version of Carom. Families and invariants are names, because this program may not know them.
struct RecordedRun {
  RunHeading heading;
  std::vector<std::string> families;
  std::vector<RecordedSubject> subjects;  // the absent ones last
  // Settings in words.
  std::string cases;
  std::string domain;
  std::string yardstick;
  std::string relations_every;
  std::string ended_early;
  std::string shard;
};

/// The change of an invariant of a subject in a family. An invariant is judged if it held or was violated in some case.
enum class Change {
  newly_violated,    // judged before, and not violated
  violated_unknown,  // violated now, not judged before; counts as new
  known,             // violated in both
  fixed,             // violated before; judged now, and not violated
  no_longer_judged,  // violated before, and not judged now
};

/// "new", "new, not judged before", "known", "fixed" or "no longer judged".
[[nodiscard]] constexpr std::string_view in_words(Change change) {
  constexpr EnumArray<Change, std::string_view, 5> words{"new", "new, not judged before", "known", "fixed",
                                                         "no longer judged"};
  return words[change];
}
[[nodiscard]] bool is_new(Change change);

struct ComparedViolation {
  Change change;
  std::string invariant;
  std::string family;
  properties::Count before;
  properties::Count now;
};

/// A subject of either report, or of both. Subjects are matched by name, otherwise by their specification on the
/// command line.
struct ComparedSubject {
  std::string name;
  bool counts = false;                         // in the newer report, its violations decide the exit status
  bool was_before = false;                     // whether the older report has the subject
  bool is_now = false;                         // whether the newer report has it
  std::vector<ComparedViolation> violations;   // by invariant, then in the order of the families
  std::vector<std::string> no_longer_claimed;  // "invariant" or "invariant@family" that was claimed before
  bool cannot_be_judged_now = false;           // now "error" or "not judged", before neither; counts as new
  std::string error;                           // why it cannot be judged now
};

/// A setting that differs between the runs, so that their numbers are not comparable.
struct Difference {
  std::string what;
  std::string before;
  std::string now;
};

struct Comparison {
  RunHeading before;
  std::vector<Difference> differences;
  std::vector<ComparedSubject> subjects;  // of the newer report, then those only in the older one

  /// `count` is the number of violations with this change. `count_new` is the number of new violations and of subjects
  /// that can no longer be judged. With `counting_alone`, only subjects that count contribute.
  [[nodiscard]] std::size_t count_new(bool counting_alone) const;
  [[nodiscard]] std::size_t count(Change change) const;
};

/// Compares two runs. Families are matched by their names, and subjects as in ComparedSubject.
[[nodiscard]] Comparison compare_runs(const RecordedRun& before, const RecordedRun& now);

/// The field `baseline` of report.json.
[[nodiscard]] nlohmann::json baseline_record(const Comparison& comparison);

/// Whether the subject violates the invariant, and none of these violations is new.
[[nodiscard]] bool is_known(const Comparison& comparison, const std::string& subject,
                            const properties::Invariant& invariant);

/// "2 new, 3 known, 1 fixed", with "1 no longer judged" if there are any.
[[nodiscard]] std::string summary_of(const Comparison& comparison);

/// "nothing new, 3 known, 1 fixed". Only new violations of subjects that count are counted as new. If other subjects
/// have new violations, their number follows in parentheses. The known and fixed violations are those of all subjects.
[[nodiscard]] std::string baseline_verdict(const Comparison& comparison);

}  // namespace carom::report
