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

/// What the gate is asked, and what came of it.
namespace carom::properties {

/// One of the parts of a run: of each family every `of`-th case, from the `number`-th on. All parts together have each
/// case once, by its own number.
struct Shard {
  std::uint64_t number = 1;  // from 1
  std::uint64_t of = 1;

  /// The number of the case that is the shard's `place`-th, from 0.
  [[nodiscard]] std::uint64_t case_number(std::uint64_t place) const { return place * of + number - 1; }
};

struct GateOptions {
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;           // of each family, times its weight
  std::vector<const Family*> families;  // in the order to report
  /// Families beyond the claimed domain, posed besides: they show where each subject stops, and decide no verdict. Not
  /// with a budget, nor where each subject is judged to its first violation alone.
  std::vector<const Family*> beyond_domain = {};
  oracles::Yardstick yardstick;  // its unit roundoff is taken from each subject
  Workers workers = {};          // each opens a session of every subject
  /// Each invariant that relates a collision to others is judged on every so many cases, the next one on other cases;
  /// 0: on every case of subjects in this process, on every fourth of programs, for which each question costs a hundred
  /// times as much. Of a fault in one of 100 answers that one such invariant alone sees, in one family alone, each of
  /// 250 cases and the question on it then shows 1 %: it is missed in one run of 150 (0.99^500).
  std::uint64_t relations_every = 0;
  /// A subject that violates an invariant is asked nothing more: of it one violation is reported, the same on any
  /// number of workers. The run ends where this holds of every subject, or all cases were judged.
  bool fail_fast = false;
  /// In place of `cases`: cases are drawn, families in turn, until so much time was spent. The violations found are
  /// then shrunk as ever.
  std::optional<std::chrono::nanoseconds> budget = {};
  /// Of all cases these alone. Precondition: without a budget.
  Shard shard = {};
  /// Whether witnesses are made as simple as can be; else each stands as it was found.
  bool shrinks = true;
  /// Where a stop is requested, what was judged until then is reported.
  std::stop_token stop;
  /// Called now and then with the cases done and those there are, with a budget with the milliseconds spent and those
  /// there are; from any thread, one call at a time.
  std::function<void(std::uint64_t done, std::uint64_t all)> progress;
};

/// So many cases are drawn of the family; with a budget there is no end to them.
[[nodiscard]] std::uint64_t cases_of(const GateOptions& options, const Family& family);

/// What a family turned out to hold.
struct Coverage {
  std::uint64_t cases = 0;
  std::uint64_t colliding = 0;
  std::uint64_t resting = 0;
  std::uint64_t separating = 0;
  std::uint64_t inert = 0;  // both bodies immovable
  std::uint64_t invalid = 0;
  std::uint64_t one_immovable = 0;
  std::uint64_t spheres = 0;    // movable bodies isotropic, lever arms exactly along the normal
  std::uint64_t head_on = 0;    // colliding with V⁻ ∥ N exactly
  std::uint64_t inelastic = 0;  // ε = 0
  std::uint64_t elastic = 0;    // ε = 1
  AdjustmentCounts adjusted;    // by the family, before anything was judged

  Coverage& operator+=(const Coverage& other);
};

/// A violation that can be replayed.
struct Witness {
  std::string invariant;
  std::string family;
  std::uint64_t index = 0;  // of the case in its family
  Case original;
  Case shrunk;      // the simplest collision found that violates the same invariant about as badly; the original where
                    // the subject could not be asked on
  Verdict verdict;  // on the shrunk collision
  Answer answer;    // to the shrunk collision
  Verdict verdict_as_found;
  Answer answer_as_found;
  bool is_reproduced = true;  // asked by itself, the original violates it too; true where it was not asked
};

struct SubjectResult {
  Subject subject;
  std::string error;                        // why the subject could not be judged to the end; empty where it was
  std::vector<FamilyResult> families;       // as in the options
  Histogram<DigitsScale> digits;            // of the colliding cases that were answered
  double nanoseconds_per_solve = 0;         // median over the batches, as seen by the gate: its own overhead included
  std::vector<Witness> witnesses;           // one for each invariant violated
  std::string not_judged;                   // why too little was exercised to call it sound; empty where enough was
  std::vector<FamilyResult> beyond_domain;  // of options.beyond_domain; empty if none was posed
  std::string error_beyond_domain;          // why it was not judged there to the end; empty if it was

  [[nodiscard]] std::uint64_t cases() const;
  [[nodiscard]] std::uint64_t skipped() const;
  [[nodiscard]] UnjudgedCounts unjudged() const;
  [[nodiscard]] Count count(const std::string& invariant) const;
  [[nodiscard]] std::vector<std::string> violated_invariants() const;  // in the order of the catalogue
  /// Judged to the end, enough was exercised, and nothing was violated.
  [[nodiscard]] bool is_sound() const;
  /// The digits that `share` of the cases have at least; 0.5, 0.99, 1. To within the bins of DigitsScale, of all cases
  /// exactly.
  [[nodiscard]] std::optional<double> digits_at_least(double share) const;
  struct WorstFamily {
    double backward_error = 0;
    std::string family;
  };
  [[nodiscard]] WorstFamily worst_backward_error(const GateOptions& options) const;
};

/// What SubjectResult::not_judged is to say:
///   - in each family of valid collisions some case is to be answered, of those that the subject's precision can hold;
///   - of all such cases at most a tenth may be skipped;
///   - a law of the outcomes of colliding contacts is to hold somewhere.
[[nodiscard]] std::string why_not_judged(const SubjectResult& result, const std::vector<const Family*>& families,
                                         const std::vector<Coverage>& coverage);

struct GateReport {
  GateOptions options;
  std::vector<Coverage> coverage;                 // of each family
  FeatureCoverage features;                       // of the colliding cases of all families
  std::vector<std::vector<SampledCase>> sampled;  // of each family, by their numbers; one that was not drawn is invalid
  std::vector<SubjectResult> results;             // of each subject
  bool interrupted = false;                       // by options.stop
};

}  // namespace carom::properties
