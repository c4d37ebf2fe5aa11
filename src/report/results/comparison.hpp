// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <carom/report/results/recorded_run.hpp>

/// The differences between two reports. Every text is a line that is safe to print.
namespace carom::report {

/// The change of an invariant of a subject in a family. An invariant is judged if it held or was violated in some case.
enum class Change {
  newly_violated,    // judged before, and not violated
  violated_unknown,  // violated now, not judged before; counts as new
  known,             // violated in both
  fixed,             // violated before; judged now, and not violated
  no_longer_judged,  // violated before, and not judged now
};

/// "new", "new, not judged before", "known", "fixed" or "no longer judged".
[[nodiscard]] std::string_view in_words(Change change);
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
  std::optional<SubjectSummary> before;        // none if the older report lacks the subject
  std::optional<SubjectSummary> now;           // none if the newer report lacks the subject
  std::vector<ComparedViolation> violations;   // by invariant, then in the order of the families
  std::vector<std::string> no_longer_claimed;  // "invariant" or "invariant@family" that was claimed before
  bool cannot_be_judged_now = false;           // now "error" or "not judged", before neither; counts as new
};

/// A setting that differs between the runs, so that their numbers are not comparable.
struct Difference {
  std::string what;
  std::string before;
  std::string now;
};

struct Comparison {
  RunHeading before;
  RunHeading now;
  std::vector<Difference> differences;
  std::vector<ComparedSubject> subjects;  // of the newer report, then those only in the older one

  /// `count` is the number of violations with this change. `count_new` is the number of new violations and of subjects
  /// that can no longer be judged. With `counting_alone`, only subjects that count contribute.
  [[nodiscard]] std::size_t count_new(bool counting_alone) const;
  [[nodiscard]] std::size_t count(Change change) const;
};

/// Compares two runs. Families are matched by their names, and subjects as in ComparedSubject.
[[nodiscard]] Comparison compare_runs(const RecordedRun& before, const RecordedRun& now);

/// Whether the subject violates the invariant, and none of these violations is new.
[[nodiscard]] bool is_known(const Comparison& comparison, const std::string& subject,
                            const properties::Invariant& invariant);

/// "2 new, 3 known, 1 fixed", with "1 no longer judged" if there are any.
[[nodiscard]] std::string summary_of(const Comparison& comparison);

/// "nothing new, 3 known, 1 fixed". Only new violations of subjects that count are counted as new. If other subjects
/// have new violations, their number follows in parentheses. The known and fixed violations are those of all subjects.
[[nodiscard]] std::string baseline_verdict(const Comparison& comparison);

}  // namespace carom::report
