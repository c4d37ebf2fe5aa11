// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <carom/properties/gate/family_result.hpp>
#include <carom/report/model/digits.hpp>

/// What differs between two reports. Texts are lines that are safe to print.
namespace carom::report {

struct Run;

/// Which run is meant.
struct RunHeading {
  std::string file;
  std::string carom;  // its version
  std::string date;
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> cases;  // of each family; none if a budget decided
  std::size_t families = 0;
  std::string shard;  // "2/3"; empty for a whole run
};

/// A subject in one line.
struct SubjectSummary {
  std::string status;   // "sound", "violated", "error", "not judged" or "absent"
  std::string error;    // why it was not judged to the end
  std::string version;  // empty where it says none
  std::string model;
  std::string precision;
  std::uint64_t cases = 0;
  std::uint64_t violated_cases = 0;            // that violated any invariant
  std::vector<std::string> violated;           // invariants
  std::optional<double> worst_backward_error;  // ulps; none where the law determines no outcome
  std::string worst_family;                    // empty where there is none
  Digits digits;
  std::vector<std::string> deviates;  // "invariant" or "invariant@family"
};

/// What became of an invariant of a subject in a family. It is judged where it held or was violated in some case; what
/// was skipped in all of them was not.
enum class Change {
  newly_violated,    // judged before, and not violated
  violated_unknown,  // violated now, and not judged before: counts as new
  known,             // violated in both
  fixed,             // violated before; judged now, and not violated
  no_longer_judged,  // violated before, and not judged now
};

/// "new", "new, not judged before", "known", "fixed", "no longer judged".
[[nodiscard]] std::string_view in_words(Change change);
[[nodiscard]] bool is_new(Change change);

struct ComparedViolation {
  Change change;
  std::string invariant;
  std::string family;
  properties::Count before;
  properties::Count now;
};

/// A subject of either report or both. One that is called otherwise but named alike on the command line is the same.
struct ComparedSubject {
  std::string name;
  bool counts = false;                         // in the newer report
  std::optional<SubjectSummary> before;        // none where it came
  std::optional<SubjectSummary> now;           // none where it went
  std::vector<ComparedViolation> violations;   // by invariant, then in the order of the families
  std::vector<std::string> no_longer_claimed;  // "invariant" or "invariant@family" that was claimed before
  bool cannot_be_judged_now = false;           // now an error or not judged, and not so before: counts as new
};

/// A setting in which the runs differ, so that numbers of one are not those of the other.
struct Difference {
  std::string what;
  std::string before;
  std::string now;
};

struct Comparison {
  RunHeading before;
  RunHeading now;
  std::vector<Difference> differences;
  std::vector<ComparedSubject> subjects;  // those of the newer report, then those that went

  /// Violations of that kind, and subjects that can be judged no longer among what is new; of all subjects, or of those
  /// that count.
  [[nodiscard]] std::size_t count_new(bool counting_alone) const;
  [[nodiscard]] std::size_t count(Change change) const;
};

/// Families that are not in both runs, and subjects that are called otherwise, are met by their names.
[[nodiscard]] Comparison compare_runs(const Run& before, const std::string& file_before, const Run& now,
                                      const std::string& file_now);

/// Whether the subject violates the invariant, in no family of which that is new.
[[nodiscard]] bool is_known(const Comparison& comparison, const std::string& subject, const std::string& invariant);

/// "2 new, 3 known, 1 fixed", and "1 no longer judged" where there is one.
[[nodiscard]] std::string summary_of(const Comparison& comparison);

/// "nothing new, 3 known, 1 fixed", of subjects that count; what is new in others is said beside it.
[[nodiscard]] std::string baseline_verdict(const Comparison& comparison);

}  // namespace carom::report
