// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/oracles/laws/judge_error.hpp>
#include <carom/properties/cases/domain.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/gate/family_result.hpp>
#include <carom/properties/gate/histogram.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/properties/gate/workers.hpp>

namespace carom::properties {

/// One part of a run: every `of`-th case of each family, from the `number`-th on. All parts together contain each case
/// once.
struct Shard {
  std::uint64_t number = 1;  // from 1
  std::uint64_t of = 1;

  /// The number, in its family, of the shard's `place`-th case. Both count from 0.
  [[nodiscard]] std::uint64_t case_number(std::uint64_t place) const { return place * of + number - 1; }
};

inline constexpr std::uint64_t default_cases = 1000;

struct GateOptions {
  std::uint64_t seed = 1;
  std::uint64_t cases = default_cases;  // per family, times its weight
  std::vector<const Family*> families;  // in the order of the report
  /// The gate draws each case into this domain. Precondition: `has_cases_within` holds for each family.
  Domain within = {};
  /// Families beyond the claimed domain. They show the limits of each subject and decide no verdict. A run with a
  /// budget or with `fail_fast` ignores them.
  std::vector<const Family*> beyond_domain = {};
  oracles::Limits limits = {};
  Workers workers = {};  // each worker opens a session of every subject
  /// Each relation is judged on one case in `relations_every`, and different relations on different cases. The value 0
  /// means 1 for subjects in this process, 2 for those of `coulomb`, whose answers take many steps, and 4 for programs,
  /// for which a question costs a hundred times as much.
  /// Suppose that one answer in 100 is wrong, and only one relation in one family of 1000 cases shows this. With 4, the
  /// relation judges 250 cases with two answers each, and one run in 150 misses the fault (0.99^500).
  std::uint64_t relations_every = 0;
  /// A subject is not asked after its first violation. The report has only this violation of the subject, the same for
  /// any number of workers.
  bool fail_fast = false;
  /// Replaces `cases`: the families take turns until this time is spent. Shrinking takes additional time.
  std::optional<std::chrono::nanoseconds> budget = {};
  /// Judges only the cases of this shard. Precondition: no budget.
  Shard shard = {};
  /// The run is a part of a measurement, as a shard is. A subject can be sound in it although no case judges some
  /// claimed invariant.
  bool is_part = false;
  bool shrinks = true;
  /// The subjects whose violations are explained, in their order: witnesses are shrunk, and the defect is diagnosed. If
  /// it is empty, all subjects are explained. Otherwise, it has a value for each subject of the run.
  std::vector<bool> explains = {};
  /// If a stop is requested, the report holds the results so far.
  std::stop_token stop;
  /// Called from time to time, by any thread, but by one thread at a time. `done` and `all` are numbers of cases, or
  /// milliseconds with a budget.
  std::function<void(std::uint64_t done, std::uint64_t all)> progress;
};

[[nodiscard]] inline bool is_explained(const GateOptions& options, std::size_t subject) {
  return options.explains.empty() || options.explains[subject];
}

/// The number of cases to draw of the family. With a budget, the largest std::uint64_t.
[[nodiscard]] std::uint64_t cases_of(const GateOptions& options, const Family& family);

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

struct Witness {
  const Invariant* invariant = nullptr;
  const Family* family = nullptr;
  std::uint64_t index = 0;  // number of the case in its family
  Case original;
  Case shrunk;      // the simplest collision found that violates the invariant about as seriously, or the original
  Verdict verdict;  // on the shrunk collision
  Answer answer;    // to the shrunk collision
  Verdict verdict_as_found;
  Answer answer_as_found;
  bool is_reproduced = true;    // whether the original, asked alone, violates the invariant; true if it was not asked
  std::string not_shrunk = {};  // the failure that ended the shrinking; empty if there was none
};

/// A use in which a subject with a violation has none, by the judgement of fresh cases.
struct WayOn {
  std::optional<Domain> within;  // a domain in which it is sound; none if effects are the way
  DeclaredEffects effects = {};  // to be declared in place of the subject's own
  std::uint64_t cases = 0;       // judged fresh cases
};

struct SubjectResult {
  Subject subject;
  std::string error;                   // why the subject could not be judged to the end; empty if it was
  std::vector<FamilyResult> families;  // in the order of the options
  Histogram<DigitsScale> digits;       // correct digits in the colliding cases that were answered
  double nanoseconds_per_solve = 0;    // median over the batches [ns], with the gate's overhead
  std::vector<Witness> witnesses;      // one for each violated invariant
  /// Why too few cases were judged to call the subject sound. Empty if enough were, or if an invariant is violated.
  std::string not_judged;
  /// The contacts that the subject answers (`what_it_answers`), if it violates an invariant and skips too many cases.
  std::string answers_alone;
  std::vector<FamilyResult> beyond_domain;  // for options.beyond_domain; empty if none was posed
  std::string error_beyond_domain;          // why the subject was not judged there to the end; empty if it was
  std::vector<WayOn> ways_on = {};          // by `add_ways_on`; empty if none was found or sought

  [[nodiscard]] std::uint64_t cases() const;
  [[nodiscard]] std::uint64_t skipped() const;
  [[nodiscard]] UnjudgedCounts unjudged() const;
  [[nodiscard]] EffectCounts decided_by() const;
  [[nodiscard]] EnergyGains energy(const GateOptions& options) const;
  [[nodiscard]] Count count(const Invariant& invariant) const;
  [[nodiscard]] std::vector<const Invariant*> violated_invariants() const;  // in the order of the catalogue
  /// The invariants that the subject claims in some family of the run, and that no case judged, in the order of the
  /// catalogue.
  [[nodiscard]] std::vector<const Invariant*> never_judged(const GateOptions& options) const;
  /// Whether the subject was judged to the end on enough cases, without a violation.
  [[nodiscard]] bool is_sound() const;
  /// The number of digits that at least the fraction `share` of the cases has, accurate to the bins of DigitsScale.
  /// Exact for `share` = 1.
  [[nodiscard]] std::optional<double> digits_at_least(double share) const;
  struct WorstFamily {
    double backward_error = 0;
    const Family* family = nullptr;  // nullptr if the error is 0 in every family
  };
  [[nodiscard]] WorstFamily worst_backward_error(const GateOptions& options) const;
};

/// The text of SubjectResult::not_judged. Empty if an invariant is violated, or if five conditions hold:
///   (1) In each family of valid collisions, the subject answers a case that its precision can hold.
///   (2) The subject skips at most a tenth of all cases that its precision can hold.
///   (3) Each effect that the subject declares decides at most a tenth of the colliding cases.
///   (4) An invariant about the outcomes of colliding contacts holds in some case. If no case collides, any invariant
///       will do.
///   (5) Each claimed invariant that can be judged in the kinds of the domain is judged in some case, or the run is a
///       shard or `is_part`.
[[nodiscard]] std::string why_not_judged(const SubjectResult& result, const GateOptions& options,
                                         const std::vector<Coverage>& coverage);

/// Whether the subject skips more than a tenth of the valid cases that its precision can hold.
[[nodiscard]] bool skips_too_many(const SubjectResult& result, const std::vector<Coverage>& coverage);

struct GateReport;

/// Sets `not_judged` and `answers_alone` of each result. If it is not judged because it skips too many cases,
/// `not_judged` says what it answers.
void state_what_was_not_judged(GateReport& report);

struct GateReport {
  GateOptions options;
  std::vector<Coverage> coverage;                 // of each family
  FeatureCoverage features;                       // of the colliding cases of all families
  std::vector<std::vector<SampledCase>> sampled;  // by family and case number; a case that was not drawn is invalid
  std::vector<SubjectResult> results;             // of each subject
  bool interrupted = false;                       // by a stop that options.stop requested
  /// The fault of the judge that ended the run. The results are those before it.
  std::optional<oracles::JudgeError> judge_error = {};
};

}  // namespace carom::properties
