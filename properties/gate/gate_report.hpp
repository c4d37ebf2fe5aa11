// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/properties/features/coverage.hpp>
#include <carom/properties/gate/family_result.hpp>
#include <carom/properties/gate/sample.hpp>
#include <carom/properties/gate/scales.hpp>
#include <carom/properties/gate/workers.hpp>
#include <carom/properties/trial/trial.hpp>

/// The options of the gate, and its results.
namespace carom::properties {

/// One part of a run: every `of`-th case of each family, from the `number`-th on. All parts together contain each case
/// once, under its own number.
struct Shard {
  std::uint64_t number = 1;  // from 1
  std::uint64_t of = 1;

  /// The number that the shard's `place`-th case has in its family, both from 0.
  [[nodiscard]] std::uint64_t case_number(std::uint64_t place) const { return place * of + number - 1; }
};

struct GateOptions {
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;           // per family, times its weight
  std::vector<const Family*> families;  // in the order of the report
  /// Families beyond the claimed domain, posed in addition. They show the limits of each subject and decide no verdict.
  /// They are not posed with a budget or with `fail_fast`.
  std::vector<const Family*> beyond_domain = {};
  oracles::Yardstick yardstick;  // with the unit roundoff of each subject
  Workers workers = {};          // each worker opens a session of every subject
  /// Each invariant that relates a collision to others is judged on one case in this many, and successive invariants on
  /// different cases. The value 0 means 1 for subjects in this process, and 4 for programs, because a question costs a
  /// program a hundred times as much. A fault is hardest to find if one answer in 100 has it, and only one such
  /// invariant in one family shows it. That family then has 250 judged cases with two answers in each, and one run in
  /// 150 misses the fault (0.99^500).
  std::uint64_t relations_every = 0;
  /// A subject that violates an invariant is not asked further. One violation of the subject is reported, the same for
  /// any number of workers. The run ends when every subject has a violation, or when all cases are judged.
  bool fail_fast = false;
  /// Replaces `cases`: the families take turns until this time is spent. The violations found are then shrunk as usual.
  std::optional<std::chrono::nanoseconds> budget = {};
  /// Only the cases of this shard are judged. Precondition: no budget.
  Shard shard = {};
  /// Whether witnesses are shrunk; otherwise each stays as it was found.
  bool shrinks = true;
  /// If a stop is requested, the report holds the results so far.
  std::stop_token stop;
  /// Called from time to time with the number of judged cases and the number of all cases. With a budget, `progress`
  /// gets the milliseconds spent and the milliseconds available. Any thread may call it, one at a time.
  std::function<void(std::uint64_t done, std::uint64_t all)> progress;
};

/// The number of cases that are drawn of the family; the largest std::uint64_t with a budget.
[[nodiscard]] std::uint64_t cases_of(const GateOptions& options, const Family& family);

/// Counts of the cases of a family.
struct Coverage {
  std::uint64_t cases = 0;
  std::uint64_t colliding = 0;
  std::uint64_t resting = 0;
  std::uint64_t separating = 0;
  std::uint64_t inert = 0;  // both bodies immovable
  std::uint64_t invalid = 0;
  std::uint64_t one_immovable = 0;
  std::uint64_t spheres = 0;    // movable bodies are isotropic, and lever arms exactly along the normal
  std::uint64_t head_on = 0;    // colliding with V⁻ ∥ N exactly
  std::uint64_t inelastic = 0;  // ε = 0
  std::uint64_t elastic = 0;    // ε = 1
  AdjustmentCounts adjusted;    // by the family, before judging

  Coverage& operator+=(const Coverage& other);
};

/// A violation that a user can replay.
struct Witness {
  std::string invariant;
  std::string family;
  std::uint64_t index = 0;  // number of the case in its family
  Case original;
  Case shrunk;      // the simplest collision found that violates the same invariant about as seriously;
                    // the original if shrinking was not possible
  Verdict verdict;  // on the shrunk collision
  Answer answer;    // to the shrunk collision
  Verdict verdict_as_found;
  Answer answer_as_found;
  bool is_reproduced = true;  // the original violates the invariant too if it is asked alone; true if it was not asked
};

struct SubjectResult {
  Subject subject;
  std::string error;                   // why the subject could not be judged to the end; empty if it was
  std::vector<FamilyResult> families;  // in the order of the options
  Histogram<DigitsScale> digits;       // correct digits in the colliding cases that were answered
  double nanoseconds_per_solve = 0;    // median over the batches [ns], with the gate's overhead
  std::vector<Witness> witnesses;      // one for each violated invariant
  std::string not_judged;              // why too few cases were judged to call the subject sound; empty if enough were
  std::vector<FamilyResult> beyond_domain;  // for options.beyond_domain; empty if none was posed
  std::string error_beyond_domain;          // why the subject was not judged there to the end; empty if it was

  [[nodiscard]] std::uint64_t cases() const;
  [[nodiscard]] std::uint64_t skipped() const;
  [[nodiscard]] UnjudgedCounts unjudged() const;
  [[nodiscard]] Count count(const std::string& invariant) const;
  [[nodiscard]] std::vector<std::string> violated_invariants() const;  // in the order of the catalogue
  /// Whether the subject was judged to the end on enough cases, and violated nothing.
  [[nodiscard]] bool is_sound() const;
  /// The number of digits that at least the fraction `share` of the cases has (0.5, 0.99, 1). Accurate to the bins of
  /// DigitsScale; exact for `share` = 1.
  [[nodiscard]] std::optional<double> digits_at_least(double share) const;
  struct WorstFamily {
    double backward_error = 0;
    std::string family;
  };
  [[nodiscard]] WorstFamily worst_backward_error(const GateOptions& options) const;
};

/// The text of SubjectResult::not_judged. It is empty if three conditions are met. First, in each family of valid
/// collisions, the subject answers some case that its precision can hold. Second, it skips at most a tenth of all such
/// cases. Third, an invariant of the outcomes of colliding contacts holds in some case; if no case collides, any
/// invariant.
[[nodiscard]] std::string why_not_judged(const SubjectResult& result, const std::vector<const Family*>& families,
                                         const std::vector<Coverage>& coverage);

struct GateReport {
  GateOptions options;
  std::vector<Coverage> coverage;                 // of each family
  FeatureCoverage features;                       // of the colliding cases of all families
  std::vector<std::vector<SampledCase>> sampled;  // by family and case number; a case that was not drawn is invalid
  std::vector<SubjectResult> results;             // of each subject
  bool interrupted = false;                       // by a stop that options.stop requested
};

}  // namespace carom::properties
