// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/diagnosis/evidence.hpp>
#include <carom/properties/diagnosis/fault.hpp>
#include <carom/properties/diagnosis/hypothesis.hpp>
#include <carom/properties/diagnosis/where.hpp>
#include <carom/properties/trial/declared_effects.hpp>

namespace carom::properties::diagnosis {
namespace {

/// For each family, the numbers of the sampled cases that violate an invariant of one answer. If no family has one, the
/// cases that violate any invariant. Relations come second, because they may fail on a case with a right answer.
std::vector<std::vector<std::uint64_t>> violated_cases(const SubjectResult& result) {
  std::vector<std::vector<std::uint64_t>> all;
  bool is_any = false;
  for (const bool of_one_answer : {true, false}) {
    if (is_any) {
      break;
    }
    all.clear();
    for (const FamilyResult& family : result.families) {
      std::set<std::uint64_t> numbers;
      for (const auto& [name, cases] : family.violated_cases) {
        if (!of_one_answer || invariant_named(name)->is_of_one_answer()) {
          numbers.insert(cases.begin(), cases.end());
        }
      }
      is_any = is_any || !numbers.empty();
      all.emplace_back(numbers.begin(), numbers.end());
    }
  }
  return all;
}

/// For each family, the number of judged sampled cases, the first of its sample.
std::vector<std::uint64_t> judged_of(const SubjectResult& result) {
  std::vector<std::uint64_t> judged;
  for (const FamilyResult& family : result.families) {
    judged.push_back(result.error.empty() ? family.sampled : std::min(family.sampled, family.cases));
  }
  return judged;
}

std::uint64_t cases_that_violate(const SubjectResult& result, const std::string& invariant) {
  std::uint64_t sum = 0;
  for (const FamilyResult& family : result.families) {
    const auto found = family.violated_cases.find(invariant);
    sum += found == family.violated_cases.end() ? 0 : found->second.size();
  }
  return sum;
}

/// The first invariant by `rank_as_cause` that nine tenths of the violated cases violate. If there is none, the
/// invariant that is violated most often.
std::string telling_invariant(const SubjectResult& result, std::uint64_t violated) {
  std::vector<std::string> names = result.violated_invariants();
  const auto is_of_relations = [](const std::string& name) { return !invariant_named(name)->is_of_one_answer(); };
  if (!std::all_of(names.begin(), names.end(), is_of_relations)) {
    // If state spoils every answer, only a repeated question shows the fault. So invariants of the session stay.
    std::erase_if(names, [&](const std::string& name) {
      return is_of_relations(name) && !invariant_named(name)->is_of_session();
    });
  }
  std::ranges::stable_sort(names, {}, [](const std::string& name) { return invariant_named(name)->rank_as_cause; });
  constexpr double most = 0.9;
  for (const std::string& name : names) {
    if (static_cast<double>(cases_that_violate(result, name)) >= most * static_cast<double>(violated)) {
      return name;
    }
  }
  return *std::max_element(names.begin(), names.end(), [&](const std::string& x, const std::string& y) {
    return cases_that_violate(result, x) < cases_that_violate(result, y);
  });
}

/// The case and the answer without the effects that the subject declares, rounded to binary64.
ViolatedCase without_effects(const ViolatedCase& one, const Subject& subject) {
  ViolatedCase changed = one;
  if (subject.effects == DeclaredEffects{} || !validate(one.one.collision).empty()) {
    return changed;
  }
  changed.one.collision = judged_collision(one.one.collision, subject.effects);
  ExactAnswer answer = lift(one.answer);
  take_out_effects(answer, subject.effects, oracles::ExactCase(changed.one.collision), subject.law, 0);
  if (const auto* outcome = std::get_if<oracles::LiftedOutcome>(&answer)) {
    changed.answer = reported(outcome->rounded());
  }
  return changed;
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

std::string counted(std::size_t part, std::size_t whole) { return fmt::format("{} of {}", part, whole); }

/// The hypothesis that explains the largest number of visibly wrong outcomes; none if this is at most half of them.
struct Explanation {
  const Hypothesis* hypothesis = nullptr;
  std::size_t explained = 0;
};

Explanation best_explanation(const std::vector<KnownCase>& cases) {
  constexpr std::size_t most_looked_at = 40;
  constexpr std::size_t most_missed_at_first = 8;  // a hypothesis that is right for half misses all 8 once in 256
  const std::span<const KnownCase> looked_at(cases.data(), std::min(cases.size(), most_looked_at));
  Explanation best;
  for (const Hypothesis& hypothesis : all_hypotheses()) {
    std::size_t explained = 0;
    std::size_t missed = 0;
    for (const KnownCase& one : looked_at) {
      const bool fits = explains(hypothesis, one);
      explained += fits ? 1 : 0;
      missed += fits ? 0 : 1;
      const bool is_hopeless = explained == 0 && missed == most_missed_at_first;
      if (is_hopeless || looked_at.size() - missed <= std::max(best.explained, (looked_at.size() - 1) / 2)) {
        break;
      }
    }
    if (explained > best.explained && 2 * explained > looked_at.size()) {
      best = {&hypothesis, explained};
    }
  }
  return best;
}

std::string last_words(const Failed& failed) {
  const std::string mark = "standard error: ";
  const std::size_t begin = failed.said.find(mark);
  if (begin == std::string::npos) {
    return {};
  }
  const std::size_t end = failed.said.find_last_not_of(" \n");
  const std::size_t line = failed.said.find_last_of('\n', end);
  const std::size_t from = line == std::string::npos || line < begin ? begin + mark.size() : line + 1;
  return ": " + failed.said.substr(from, end + 1 - from);
}

/// The faults of answers that are not outcomes of finite numbers.
std::vector<Fault> without_outcome(const std::vector<ViolatedCase>& examples) {
  std::size_t failed = 0;
  std::size_t refused = 0;
  std::size_t not_finite = 0;
  std::string how;
  std::string why;
  for (const ViolatedCase& one : examples) {
    if (const auto* failure = std::get_if<Failed>(&one.answer)) {
      ++failed;
      how = how.empty() ? failure->why + last_words(*failure) : how;
    } else if (const auto* refusal = std::get_if<Refused>(&one.answer)) {
      ++refused;
      why = why.empty() ? refusal->why : why;
    } else if (const auto* outcome = std::get_if<ReportedOutcome>(&one.answer)) {
      not_finite += oracles::is_finite(*outcome) || !validate(one.one.collision).empty() ? 0 : 1;
    }
  }
  std::vector<Fault> faults;
  if (failed > 0) {
    faults.push_back(
        {fmt::format("It fails to answer in {} examined violated cases: it {}.", counted(failed, examples.size()), how),
         "its standard error output, below the witness"});
  }
  if (not_finite > 0) {
    faults.push_back({fmt::format("Its answer contains infinities or NaN in {} examined violated cases.",
                                  counted(not_finite, examples.size())),
                      "divisions by zero, square roots of negative numbers, overflow of squares"});
  }
  if (refused > 0) {
    faults.push_back({fmt::format("It refuses valid collisions in {} examined violated cases: {}",
                                  counted(refused, examples.size()), why),
                      "the check of the input"});
  }
  return faults;
}

/// The defects of the first invalid collision that was not refused.
std::string first_invalid(const std::vector<ViolatedCase>& examples) {
  for (const ViolatedCase& one : examples) {
    if (const std::vector<Defect> defects = validate(one.one.collision); !defects.empty()) {
      return ", for example one with " + describe(defects);
    }
  }
  return {};
}

/// The fault of the matrix that a subject shows, if nothing else is wrong.
std::optional<Fault> fault_of_matrix(const SubjectResult& result) {
  const std::vector<std::string> violated = result.violated_invariants();
  const bool is_all = std::all_of(violated.begin(), violated.end(),
                                  [](const std::string& name) { return invariant_named(name)->is_of_matrix(); });
  if (!is_all || violated.empty()) {
    return std::nullopt;
  }
  return result.count("matrix_used").violated > 0
             ? Fault{"Its outcomes are right. The collision matrix that it shows is not symmetric, or is not the one that it solves with.",
                     "the shown matrix: its axes, its rows and columns, the contact that it belongs to"}
             : Fault{"Its outcomes are right. The collision matrix that it shows is not positive definite, or it is too large.",
                     "the computation of C: signs, the transpose of [r], the moments of inertia"};
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

Fault what_is_wrong(const SubjectResult& result, const std::vector<ViolatedCase>& examples, const Where& where,
                    bool is_cut_short) {
  if (const std::optional<Fault> of_matrix = fault_of_matrix(result)) {
    return *of_matrix;
  }
  std::vector<Fault> faults = without_outcome(examples);
  const auto violates = [&](bool (Invariant::*is_such)() const) {
    return std::ranges::any_of(all_invariants(), [&](const Invariant& invariant) {
      return (invariant.*is_such)() && result.count(std::string(invariant.name)).violated > 0;
    });
  };
  if (violates(&Invariant::is_of_invalid)) {
    faults.push_back(
        {"It does not refuse invalid collisions" + first_invalid(examples) + ".", "the check of the input"});
  }
  std::vector<ViolatedCase> outcomes;
  std::vector<KnownCase> off;
  const double roundoff = unit_roundoff(result.subject.precision);
  for (const ViolatedCase& one : examples) {
    const auto* outcome = std::get_if<ReportedOutcome>(&one.answer);
    if (outcome == nullptr || !oracles::is_finite(*outcome) || !JudgedCase(one.one).is_valid()) {
      continue;
    }
    outcomes.push_back(one);
    if (const std::optional<KnownCase> known = known_case(one, result.subject.law)) {
      if (is_visibly_off(*known, roundoff)) {
        off.push_back(*known);
      }
    }
  }
  const auto lost = static_cast<std::size_t>(std::count_if(result.witnesses.begin(), result.witnesses.end(),
                                                           [](const Witness& one) { return !one.is_reproduced; }));
  if (lost > 0) {
    faults.push_back(
        {fmt::format("It keeps state from earlier collisions: {} witnesses get another answer if they are asked alone.",
                     counted(lost, result.witnesses.size())),
         "caches and their keys, warm starts, state that is not reset between contacts"});
  }
  const Explanation best = off.size() < least_violated ? Explanation() : best_explanation(off);
  if (best.hypothesis != nullptr) {
    faults.push_back({fmt::format("It answers as if {} ({} examined wrong outcomes).", best.hypothesis->as_if,
                                  counted(best.explained, std::min<std::size_t>(off.size(), 40))),
                      best.hypothesis->look_at});
  } else if (violates(&Invariant::is_of_session)) {
    faults.push_back(
        {"It gives another answer if it is asked again: it keeps state from earlier collisions, or its answer depends "
         "on the spelling of the request.",
         "caches, warm starts, state that is not reset; the parser of numbers and of optional fields"});
  } else if (faults.empty() ? !outcomes.empty()
                            : outcomes.size() >= least_violated && 5 * outcomes.size() > examples.size()) {
    faults.push_back(fault_of_outcomes(outcomes, result.subject.law, where, is_cut_short));
  }
  Fault joined;
  for (const Fault& fault : faults) {
    joined.what += (joined.what.empty() ? "" : " ") + fault.what;
    joined.look_at += (joined.look_at.empty() || fault.look_at.empty() ? "" : "; ") + fault.look_at;
  }
  return joined;
}

}  // namespace

Diagnosis diagnose(const SubjectResult& result, const GateReport& report) {
  Diagnosis diagnosis;
  const std::vector<std::vector<std::uint64_t>> violated = violated_cases(result);
  for (const auto& of_family : violated) {
    diagnosis.violated += of_family.size();
  }
  diagnosis.telling = telling_invariant(result, diagnosis.violated);
  diagnosis.telling_in = cases_that_violate(result, diagnosis.telling);
  const Where where = where_violated(report, {violated, judged_of(result)});
  const Fault fault = what_is_wrong(result, examples_of(result), where, report.options.fail_fast);
  diagnosis.what = fault.what;
  diagnosis.look_at = fault.look_at;
  diagnosis.where = in_words(where);
  return diagnosis;
}

std::vector<Diagnosis> diagnose_all(const GateReport& report) {
  std::vector<Diagnosis> diagnoses(report.results.size());
  report.options.workers.run(diagnoses.size(), [&](std::size_t s) {
    if (!report.results[s].violated_invariants().empty()) {
      diagnoses[s] = diagnose(report.results[s], report);
    }
  });
  return diagnoses;
}

}  // namespace carom::properties::diagnosis
