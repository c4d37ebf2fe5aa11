// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/explanation.hpp>
#include <carom/properties/diagnosis/faults.hpp>
#include <carom/properties/diagnosis/known_case.hpp>
#include <carom/properties/diagnosis/plain_faults.hpp>
#include <carom/properties/diagnosis/where.hpp>

namespace carom::properties::diagnosis {
namespace {

/// The numbers of cases by family, ascending.
using CaseNumbers = std::vector<std::vector<std::uint64_t>>;

ViolatedCase with_outcome(std::uint64_t index, const Collision& collision, const Outcome<double>& outcome) {
  Case one;
  one.collision = collision;
  return {index, one,
          ReportedOutcome(map_outcome<long double>(outcome, [](double x) { return static_cast<long double>(x); }))};
}

/// The first violated cases, one of each family in turn, without declared effects.
std::vector<ViolatedCase> examples_of(const SubjectResult& result) {
  std::vector<ViolatedCase> examples;
  for (const auto first : {&FamilyResult::first_violated, &FamilyResult::first_violated_by_relations}) {
    for (std::size_t round = 0; round < most_violated_kept; ++round) {
      for (const FamilyResult& family : result.families) {
        if (round < (family.*first).size()) {
          examples.push_back((family.*first)[round]);
        }
      }
    }
    if (!examples.empty()) {
      break;
    }
  }
  constexpr std::size_t most_examples = 120;
  examples.resize(std::min(examples.size(), most_examples), {0, {}, Skipped{}});
  std::ranges::transform(examples, examples.begin(),
                         [&](const ViolatedCase& one) { return without_effects(one, result.subject); });
  return examples;
}

/// The errors of the first invalid collision that was not refused.
std::string first_invalid(std::span<const ViolatedCase> examples) {
  for (const ViolatedCase& one : examples) {
    if (const std::vector<InputError> errors = validate(one.one.collision); !errors.empty()) {
      return ", for example one with " + describe(errors);
    }
  }
  return {};
}

bool lacks_matrix(const ViolatedCase& one) {
  const auto* const outcome = std::get_if<ReportedOutcome>(&one.answer);
  return outcome != nullptr && !outcome->collision_matrix;
}

/// The kind of fault of the shown matrices. `violated_by` are the invariants that the cases violate, and how often.
MatrixFault matrix_fault(std::size_t cases, const PerInvariant<std::size_t>& violated_by,
                         std::span<const ViolatedCase> examples) {
  if (std::ranges::any_of(examples, lacks_matrix)) {
    return MatrixFault::missing;
  }
  const bool is_out_of_bounds = std::ranges::any_of(violated_by, [&](const auto& violated) {
    const auto* const about = std::get_if<AboutMatrix>(&violated.first->about);
    return about != nullptr && about->is_bound && 2 * violated.second > cases;
  });
  return is_out_of_bounds ? MatrixFault::out_of_bounds : MatrixFault::another;
}

/// The step of mechanics at which the outcomes fail, with the usual cause of the conditions that they share. If there
/// are too few outcomes for a hint, the fault states only their number.
Fault fault_of_outcomes(const std::vector<ViolatedCase>& outcomes, Law law, const Where& where, bool is_cut_short) {
  if (outcomes.size() < least_violated) {
    const std::string few =
        outcomes.size() == 1 ? "1 violated case was" : fmt::format("{} violated cases were", outcomes.size());
    return {fmt::format("Only {} examined, and a hint on the cause needs {}. Judge more cases{}.", few, least_violated,
                        is_cut_short ? " without --fail-fast" : ""),
            ""};
  }
  Fault fault = fault_of(outcomes, law);
  for (const Condition& condition : where.conditions) {
    if (!condition.usual_cause.empty()) {
      fault.look_at = condition.usual_cause + "; " + fault.look_at;
    }
  }
  return fault;
}

/// Whether the velocities of an immovable body change, but for a limit that shortens them, and for storage in binary32.
bool moves_immovable(const KnownCase& one) {
  const auto is_shortened = [](const Vector3<double>& before, const Vector3<double>& after) {
    if (after == before.cast<float>().cast<double>()) {
      return true;
    }
    constexpr double rounding = 0x1p-40;
    const double share = after.stableNorm() / before.stableNorm();
    return before == after || (share < 1 && (after - share * before).stableNorm() <= rounding * after.stableNorm());
  };
  const auto moves = [&](const Body& body, const BodyVelocity<double>& after) {
    return body.immovable && !(is_shortened(body.velocity, after.velocity) &&
                               is_shortened(body.angular_velocity, after.angular_velocity));
  };
  return moves(one.collision.a, one.answered.a) || moves(one.collision.b, one.answered.b);
}

struct CasePlace {
  std::size_t family;
  std::uint64_t index;
};

std::size_t size_of(const CaseNumbers& cases) {
  std::size_t sum = 0;
  for (const auto& of_family : cases) {
    sum += of_family.size();
  }
  return sum;
}

class FaultSearch {
 public:
  FaultSearch(const SubjectResult& result, const GateReport& report, const Violations& violations)
      : result_(result), report_(report), violations_(violations), examples_(examples_of(result)) {}

  std::vector<Fault> run() && {
    add_matrix();
    if (violates_only_matrix()) {
      return std::move(faults_);
    }
    add_other_answers();
    add_invalid();
    add_outcomes();
    std::ranges::stable_sort(faults_, std::ranges::greater(), &Fault::cases);
    return std::move(faults_);
  }

 private:
  /// Whether the case is valid. A sample ends with its last valid case.
  [[nodiscard]] bool is_valid(std::size_t family, std::uint64_t index) const {
    return index < report_.sampled[family].size() && report_.sampled[family][index].is_valid;
  }

  [[nodiscard]] CaseNumbers none() const { return CaseNumbers(result_.families.size()); }

  [[nodiscard]] bool violates_only_matrix() const {
    return std::ranges::all_of(result_.violated_invariants(),
                               [](const Invariant* invariant) { return invariant->is_of_matrix(); });
  }

  [[nodiscard]] bool violates(bool (Invariant::*is_such)() const) const {
    return std::ranges::any_of(all_invariants(), [&](const Invariant& invariant) {
      return (invariant.*is_such)() && result_.count(invariant).violated > 0;
    });
  }

  /// The case, with the violated invariant that comes first as a cause. None if the case violates nothing.
  [[nodiscard]] std::optional<FaultWitness> witness_at(std::size_t family, std::uint64_t index) const {
    const Invariant* first = nullptr;
    for (const auto& [invariant, numbers] : result_.families[family].violated_cases) {
      const auto place = [](const Invariant* one) { return std::pair(one->rank_as_cause, one->name); };
      const bool is_earlier = first == nullptr || place(invariant) < place(first);
      if (is_earlier && std::ranges::binary_search(numbers, index)) {
        first = invariant;
      }
    }
    if (first == nullptr) {
      return std::nullopt;
    }
    return FaultWitness{report_.options.families[family], index, first};
  }

  [[nodiscard]] std::optional<FaultWitness> witness_in(const CaseNumbers& cases) const {
    for (std::size_t f = 0; f < cases.size(); ++f) {
      if (!cases[f].empty()) {
        return witness_at(f, cases[f].front());
      }
    }
    return std::nullopt;
  }

  /// Adds a fault that happens in `cases`.
  void add(Fault fault, const CaseNumbers& cases, std::uint64_t every = 1) {
    fault.cases = size_of(cases);
    fault.where = in_words(where_violated(report_, {cases, violations_.judged, {}, every}));
    fault.witness = witness_in(cases);
    faults_.push_back(std::move(fault));
  }

  /// Adds the fault of the shown matrix, if it also happens where the outcome is right.
  void add_matrix() {
    matrix_alone_ = none();
    std::size_t right = 0;
    for (std::size_t f = 0; f < matrix_alone_.size(); ++f) {
      std::set<std::uint64_t> of_matrix;
      std::set<std::uint64_t> others;
      for (const auto& [invariant, numbers] : result_.families[f].violated_cases) {
        if (invariant->is_of_one_answer()) {
          (invariant->is_of_matrix() ? of_matrix : others).insert(numbers.begin(), numbers.end());
        }
      }
      std::ranges::set_difference(of_matrix, others, std::back_inserter(matrix_alone_[f]));
      for (std::uint64_t index = 0; index < violations_.judged[f].first; ++index) {
        const bool collides = violations_.judged[f].has(index) && is_valid(f, index) &&
                              report_.sampled[f][index].approach == oracles::ContactState::colliding;
        right += collides && !others.contains(index) ? 1 : 0;
      }
    }
    // A wrong computation also forms a wrong matrix in some cases where the outcome is right by chance: C is wrong
    // across F only. So the matrix is a fault of its own if it is wrong in most colliding cases with a right outcome.
    if (size_of(matrix_alone_) >= std::max<std::size_t>(least_violated, (right + 1) / 2)) {
      PerInvariant<std::size_t> violated_by;
      for (std::size_t f = 0; f < matrix_alone_.size(); ++f) {
        for (const auto& violated : result_.families[f].violated_cases) {
          violated_by[violated.first] +=
              static_cast<std::size_t>(std::ranges::count_if(matrix_alone_[f], [&](std::uint64_t index) {
                return std::ranges::binary_search(violated.second, index);
              }));
        }
      }
      add(fault_of_matrix(matrix_fault(size_of(matrix_alone_), violated_by, examples_)), matrix_alone_);
    }
  }

  void add_other_answers() {
    for (FaultOfKind& one : faults_without_outcome(examples_)) {
      CaseNumbers cases = none();
      for (std::size_t f = 0; f < cases.size(); ++f) {
        for (const SampledAnswer& answer : result_.families[f].sampled_answers) {
          if (answer.kind == one.kind && is_valid(f, answer.index)) {
            cases[f].push_back(answer.index);
          }
        }
      }
      add(std::move(one.fault), cases);
    }
  }

  void add_invalid() {
    if (!violates(&Invariant::is_of_invalid)) {
      return;
    }
    CaseNumbers cases = none();
    for (std::size_t f = 0; f < cases.size(); ++f) {
      for (const std::uint64_t index : violations_.violated[f]) {
        if (!is_valid(f, index)) {
          cases[f].push_back(index);
        }
      }
    }
    add({"It does not refuse invalid collisions" + first_invalid(examples_) + ".", "the check of the input"}, cases);
  }

  /// Sorts the wrong outcomes into those that are visibly off, and those that may be rounding.
  void examine_outcomes() {
    std::size_t count = 0;
    for (const FamilyResult& family : result_.families) {
      count += family.sampled_answers.size();
    }
    constexpr std::size_t most_examined = 12'000;  // so that a limit is found within a few percent
    examine_one_in(std::max<std::size_t>(1, (count + most_examined - 1) / most_examined));
    if (every_ > 1 && every_ * wrong_.size() <= most_examined) {
      examine_one_in(1);
    }
  }

  /// Examines one outcome in `every`.
  void examine_one_in(std::size_t every) {
    every_ = every;
    wrong_.clear();
    places_.clear();
    const Precision precision = narrow_.are_binary32() ? Precision::binary32 : result_.subject.precision;
    roundoff_ = unit_roundoff(precision);
    const std::optional<int> digits = report_.options.limits.digits;
    small_ = none();
    of_immovable_ = none();
    for (std::size_t f = 0; f < result_.families.size(); ++f) {
      for (const SampledAnswer& answer : result_.families[f].sampled_answers) {
        if (answer.kind != AnswerKind::outcome || !is_valid(f, answer.index) || !is_examined(answer.index, every_) ||
            std::ranges::binary_search(matrix_alone_[f], answer.index)) {
          continue;
        }
        auto known = known_case(
            without_effects(with_outcome(answer.index, report_.sampled[f][answer.index].collision, answer.outcome),
                            result_.subject),
            result_.subject.law);
        if (known && digits) {
          constexpr double few_errors = 4;  // those of the claimed digits, and of the model of the mistake
          known->near =
              few_errors * std::pow(10, -*digits) * energy_distance(known->collision, known->before, known->truth);
        }
        if (known && moves_immovable(*known)) {
          of_immovable_[f].push_back(answer.index);
        } else if (known && is_visibly_off(*known, roundoff_)) {
          places_.push_back({f, answer.index});
          wrong_.push_back(*known);
        } else {
          small_[f].push_back(answer.index);
        }
      }
    }
  }

  /// Adds the fault that a subject of a higher precision answers in binary32.
  void add_narrow() {
    if (result_.subject.precision == Precision::binary32) {
      return;
    }
    CaseNumbers cases = none();
    for (std::size_t f = 0; f < cases.size(); ++f) {
      for (const SampledAnswer& answer : result_.families[f].sampled_answers) {
        if (answer.kind == AnswerKind::outcome && is_valid(f, answer.index)) {
          narrow_.add(report_.sampled[f][answer.index].collision, answer.outcome);
          cases[f].push_back(answer.index);
        }
      }
    }
    if (narrow_.are_binary32()) {
      add(narrow_.fault(result_.subject.precision), cases);
    }
  }

  /// Some sampled cases with right answers.
  [[nodiscard]] std::vector<KnownCase> right_cases() const {
    constexpr std::size_t most = 4;  // of a family
    std::vector<KnownCase> right;
    for (std::size_t f = 0; f < result_.families.size(); ++f) {
      std::size_t count = 0;
      for (std::uint64_t index = 0; index < violations_.judged[f].first && count < most; ++index) {
        if (violations_.judged[f].has(index) && is_valid(f, index) &&
            !std::ranges::binary_search(violations_.violated[f], index)) {
          const Collision& collision = report_.sampled[f][index].collision;
          if (auto known = known_case(collision, unchanged(collision), result_.subject.law)) {
            known->answered = known->truth;
            right.push_back(*known);
            ++count;
          }
        }
      }
    }
    return right;
  }

  void add_outcomes() {
    add_narrow();
    examine_outcomes();
    const bool moves = size_of(of_immovable_) >= least_violated;
    if (moves) {
      add({"An immovable body's velocity or spin changes.", "the treatment of bodies of infinite mass"}, of_immovable_,
          every_);
    }
    const bool has_state = violates(&Invariant::is_of_session);
    // State may change the size of each impulse, whatever the other faults.
    std::vector<Hypothesis> known = has_state ? std::vector{impulses_of_any_size()} : std::vector<Hypothesis>();
    const std::size_t first = known.size();
    const Explanation explanation = wrong_.size() < least_violated
                                        ? Explanation()
                                        : explanation_of(wrong_, roundoff_, std::move(known), right_cases());
    CaseNumbers rest = none();
    for (std::size_t i = 0; i < explanation.by.size(); ++i) {
      const std::vector<std::size_t>& by = explanation.by[i];
      if (by.empty() || (has_state && by.front() == 0)) {
        rest[places_[i].family].push_back(places_[i].index);
      }
    }
    CaseNumbers unknown = rest;
    for (std::size_t f = 0; f < small_.size(); ++f) {
      unknown[f].insert(unknown[f].end(), small_[f].begin(), small_[f].end());
      std::ranges::sort(unknown[f]);
    }
    // A hypothesis of few wrong outcomes may be what another fault looks like in special cases. So if two thirds of the
    // wrong outcomes stay unexplained, the step at which they fail is named instead.
    const bool is_explained = explanation.found.size() > first && (has_state || 3 * size_of(rest) <= 2 * wrong_.size());
    for (std::size_t h = first; is_explained && h < explanation.found.size(); ++h) {
      add_explained(explanation, h, unknown);
    }
    if (add_state(rest, is_explained) || is_explained) {
      return;
    }
    if (explanation.found.size() > first || (moves && wrong_.size() >= least_violated)) {
      add_step(outcomes_of(rest), rest, every_);
    } else if (!moves) {
      add_unexplained(rest);
    }
  }

  /// Adds the fault of a hypothesis. `unknown` lists the cases that may have it. Cases of other faults in which it does
  /// not matter say nothing about where it happens.
  void add_explained(const Explanation& explanation, std::size_t number, const CaseNumbers& unknown) {
    CaseNumbers cases = none();
    CaseNumbers needing = none();  // only this hypothesis explains them, with or without others
    CaseNumbers alone = none();    // this hypothesis suffices
    CaseNumbers maybe = unknown;
    const auto has_it = [&](const std::vector<std::size_t>& some) {
      return std::ranges::find(some, number) != some.end();
    };
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto& [family, index] = places_[i];
      const bool is_other = number > 0 && !explanation.by[i].empty() && !has_it(explanation.by[i]);
      if (explanation.needed[i].size() < explanation.by[i].size() ||
          (is_other && !matters(explanation.found[number], wrong_[i]))) {
        maybe[family].push_back(index);
      }
      if (has_it(explanation.needed[i])) {
        needing[family].push_back(index);
      }
      if (has_it(explanation.by[i])) {
        cases[family].push_back(index);
        if (explanation.by[i].size() == 1) {
          alone[family].push_back(index);
        }
      }
    }
    const CaseNumbers& there = size_of(needing) >= least_violated ? needing : cases;
    CaseNumbers left_out = none();
    for (std::size_t f = 0; f < left_out.size(); ++f) {
      std::ranges::sort(maybe[f]);
      maybe[f].erase(std::unique(maybe[f].begin(), maybe[f].end()), maybe[f].end());
      std::ranges::set_difference(maybe[f], there[f], std::back_inserter(left_out[f]));
    }
    const Hypothesis& hypothesis = explanation.found[number];
    const Where where = where_violated(report_, {there, violations_.judged, std::move(left_out), every_});
    const bool is_main = 2 * size_of(cases) >= wrong_.size();
    if (hypothesis.needs_condition && !is_main && where.conditions.empty()) {
      return;
    }
    if (number > 0 && !is_main && is_refuted(explanation, number, where)) {
      return;
    }
    Fault fault{fmt::format("It answers as if {}.", hypothesis.as_if), hypothesis.look_at};
    const Condition* const told = told_condition(where);
    if (told != nullptr && told->words.starts_with(nearly_holds)) {
      fault.look_at = told->usual_cause + "; " + fault.look_at;
    }
    fault.cases = size_of(cases);
    fault.where = in_words(where);
    fault.witness = witness_in(size_of(alone) > 0 ? alone : cases);
    faults_.push_back(std::move(fault));
  }

  /// Whether a further hypothesis gives wrong answers to most of the cases in which it matters, and has no condition
  /// that leaves them out.
  [[nodiscard]] bool is_refuted(const Explanation& explanation, std::size_t number, const Where& where) const {
    std::size_t with_it = 0;
    std::size_t without_it = 0;
    for (std::size_t i = 0; i < wrong_.size(); ++i) {
      const std::vector<std::size_t>& by = explanation.by[i];
      if (std::ranges::find(by, number) != by.end()) {
        ++with_it;
      } else if (!by.empty() && matters(explanation.found[number], wrong_[i])) {
        ++without_it;
      }
    }
    const bool is_condition_clear = !where.conditions.empty() && 2 * where.there.violated >= where.there.cases;
    return with_it < without_it && !is_condition_clear;
  }

  /// Whether each mistake of the hypothesis gives an answer other than the law's.
  [[nodiscard]] static bool matters(const Hypothesis& hypothesis, const KnownCase& one) {
    return std::ranges::all_of(hypothesis.mistakes, [&](const Mistake& mistake) {
      Steps steps = right_steps(one);
      const auto outcome = mistake(steps, one) ? outcome_of(steps, one) : std::nullopt;
      return outcome && energy_distance(one.collision, *outcome, one.truth) > tolerance_of(one);
    });
  }

  /// Adds the fault that answers depend on earlier collisions. Returns whether there is one.
  bool add_state(const CaseNumbers& rest, bool is_explained) {
    const bool is_of_rest = size_of(rest) >= least_violated;
    const CaseNumbers& cases = is_of_rest ? rest : violations_.violated;
    const std::uint64_t every = is_of_rest ? every_ : 1;
    const auto lost = std::ranges::count_if(result_.witnesses, [](const Witness& one) { return !one.is_reproduced; });
    if (lost > 0) {
      add({fmt::format("It keeps state from earlier collisions: {} of {} witnesses get another answer if they are "
                       "asked alone.",
                       lost, result_.witnesses.size()),
           "caches and their keys, warm starts, random numbers, state that is not reset between contacts"},
          cases, every);
      return true;
    }
    if (violates(&Invariant::is_of_session) && (!is_explained || size_of(rest) >= least_violated)) {
      add(fault_of_memory(), cases, every);
      return true;
    }
    return false;
  }

  /// Adds the step of mechanics at which the outcomes fail that no hypothesis explains.
  void add_unexplained(const CaseNumbers& rest) {
    std::vector<ViolatedCase> outcomes;
    for (const ViolatedCase& one : examples_) {
      if (kind_of(one.answer) == AnswerKind::outcome && validate(one.one.collision).empty()) {
        outcomes.push_back(one);
      }
    }
    if (narrow_.are_binary32() && wrong_.size() < least_violated) {
      return;
    }
    if (faults_.empty() ? !outcomes.empty()
                        : outcomes.size() >= least_violated && 5 * outcomes.size() > examples_.size()) {
      const bool is_of_all = faults_.empty() || size_of(rest) == 0;
      add_step(outcomes, is_of_all ? violations_.violated : rest, is_of_all ? 1 : every_);
    }
  }

  /// Adds the step at which the outcomes fail, unless an earlier fault states it.
  void add_step(const std::vector<ViolatedCase>& outcomes, const CaseNumbers& cases, std::uint64_t every) {
    const Where where = where_violated(report_, {cases, violations_.judged, {}, every});
    Fault fault = fault_of_outcomes(outcomes, result_.subject.law, where, report_.options.fail_fast);
    if (std::ranges::find(faults_, fault.what, &Fault::what) == faults_.end()) {
      add(std::move(fault), cases, every);
    }
  }

  /// Some of the cases with their outcomes.
  [[nodiscard]] std::vector<ViolatedCase> outcomes_of(const CaseNumbers& cases) const {
    constexpr std::size_t most = 120;
    const std::size_t every = size_of(cases) / most + 1;
    std::vector<ViolatedCase> outcomes;
    std::size_t number = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto& [family, index] = places_[i];
      if (std::ranges::binary_search(cases[family], index) && number++ % every == 0) {
        outcomes.push_back(with_outcome(index, wrong_[i].collision, wrong_[i].answered));
      }
    }
    return outcomes;
  }

  const SubjectResult& result_;
  const GateReport& report_;
  const Violations& violations_;
  std::vector<ViolatedCase> examples_;
  std::vector<Fault> faults_;
  std::vector<KnownCase> wrong_;   // visibly off
  std::vector<CasePlace> places_;  // of wrong_
  double roundoff_ = 0;            // of the subject
  std::uint64_t every_ = 1;        // one outcome in so many is examined
  CaseNumbers matrix_alone_;       // only invariants of the matrix are violated
  CaseNumbers of_immovable_;       // an immovable body moves otherwise
  CaseNumbers small_;              // wrong outcomes that are not visibly off
  NarrowAnswers narrow_;           // the examined outcomes, unless the subject claims binary32
};

}  // namespace

std::vector<Fault> faults_of(const SubjectResult& result, const GateReport& report, const Violations& violations) {
  return FaultSearch(result, report, violations).run();
}

}  // namespace carom::properties::diagnosis
