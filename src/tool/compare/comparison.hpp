// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/read_report.hpp"

/// What differs between two reports.
namespace carom::tool::compare {

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
  ReadCount before;
  ReadCount now;
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
  ReadReport before;
  ReadReport now;
  std::vector<Difference> differences;
  std::vector<ComparedSubject> subjects;  // those of the newer report, then those that went

  /// Violations of that kind, and subjects that can be judged no longer among what is new; of all subjects, or of those
  /// that count.
  [[nodiscard]] std::size_t count_new(bool counting_alone) const;
  [[nodiscard]] std::size_t count(Change change) const;
};

[[nodiscard]] Comparison compare_reports(ReadReport before, ReadReport now);

/// Whether the subject violates the invariant, in no family of which that is new.
[[nodiscard]] bool is_known(const Comparison& comparison, const std::string& subject, const std::string& invariant);

/// "2 new, 3 known, 1 fixed", and "1 no longer judged" where there is one.
[[nodiscard]] std::string summary_of(const Comparison& comparison);

/// "nothing new, 3 known, 1 fixed", of subjects that count; what is new in others is said beside it.
[[nodiscard]] std::string baseline_verdict(const Comparison& comparison);

}  // namespace carom::tool::compare
