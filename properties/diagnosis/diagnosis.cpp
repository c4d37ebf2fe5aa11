// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/diagnosis/fault.hpp>
#include <carom/properties/diagnosis/hypothesis.hpp>
#include <carom/properties/diagnosis/where.hpp>

namespace carom::properties::diagnosis {
namespace {

/// Of each family, the numbers of the sampled cases whose answers are wrong by themselves; where there are none, those
/// that violate anything: what relates answers shows a fault also where the answer in question is right.
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

/// A subject that was judged no further was judged on the first cases of each family.
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

/// The first in the order of causes that is violated in most of the violated cases; else the one violated most.
std::string telling_invariant(const SubjectResult& result, std::uint64_t violated) {
  std::vector<std::string> names = result.violated_invariants();
  const auto is_of_relations = [](const std::string& name) { return !invariant_named(name)->is_of_one_answer(); };
  if (!std::all_of(names.begin(), names.end(), is_of_relations)) {
    // State spoils everything, and only asking again shows it.
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

/// The cases that are looked at: the first of each family, in turns.
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
  return examples;
}

std::string counted(std::size_t part, std::size_t whole) { return fmt::format("{} of {}", part, whole); }

/// What explains most outcomes that are visibly off; none where that is less than half of them.
struct Explanation {
  const Hypothesis* hypothesis = nullptr;
  std::size_t explained = 0;
};

Explanation best_explanation(const std::vector<KnownCase>& cases) {
  constexpr std::size_t most_looked_at = 40;
  constexpr std::size_t most_missed_at_first = 8;  // what explains half of them fits none of eight once in 256 times
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

/// The last line of what it wrote on standard error.
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

/// What the answers are that are no outcomes of finite numbers, or to no valid collisions.
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
    faults.push_back({fmt::format("It fails to answer: in {} violated cases looked at it {}.",
                                  counted(failed, examples.size()), how),
                      "what it wrote on standard error, below the witness"});
  }
  if (not_finite > 0) {
    faults.push_back({fmt::format("It answers with numbers that are not finite in {} violated cases looked at.",
                                  counted(not_finite, examples.size())),
                      "divisions by what may be zero, square roots of what may be negative, overflow of squares"});
  }
  if (refused > 0) {
    faults.push_back({fmt::format("It refuses valid collisions in {} violated cases looked at: {}",
                                  counted(refused, examples.size()), why),
                      "what it takes for a valid collision"});
  }
  return faults;
}

/// What is wrong with the first invalid collision that was not refused.
std::string first_invalid(const std::vector<ViolatedCase>& examples) {
  for (const ViolatedCase& one : examples) {
    if (const std::vector<Defect> defects = validate(one.one.collision); !defects.empty()) {
      return ", such as one with " + describe(defects);
    }
  }
  return {};
}

/// What is wrong with the matrix that a subject shows, where that is all that is wrong; nothing elsewhere.
std::optional<Fault> fault_of_matrix(const SubjectResult& result) {
  const std::vector<std::string> violated = result.violated_invariants();
  const bool is_all = std::all_of(violated.begin(), violated.end(),
                                  [](const std::string& name) { return invariant_named(name)->is_of_matrix(); });
  if (!is_all || violated.empty()) {
    return std::nullopt;
  }
  return result.count("matrix_used").violated > 0
             ? Fault{"Its outcomes are right by themselves. The collision matrix that it shows is not symmetric, or is "
                     "not the one that it solves with.",
                     "what is shown: its axes, its rows and columns, of which contact it is"}
             : Fault{"Its outcomes are right by themselves. The collision matrix that it shows is not positive "
                     "definite, or too large.",
                     "how C is formed: signs, the transpose of [r], moments"};
}

Fault what_is_wrong(const SubjectResult& result, const std::vector<ViolatedCase>& examples) {
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
    faults.push_back({"It does not refuse invalid collisions" + first_invalid(examples) + ".",
                      "what it takes for a valid collision"});
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
        {fmt::format("It remembers something of the collisions before: {} witnesses are answered otherwise "
                     "when they are asked by themselves.",
                     counted(lost, result.witnesses.size())),
         "caches and their keys, warm starts, what is not reset between contacts"});
  }
  const Explanation best = best_explanation(off);
  if (best.hypothesis != nullptr) {
    faults.push_back({fmt::format("It answers as if {} (in {} wrong outcomes looked at).", best.hypothesis->as_if,
                                  counted(best.explained, std::min<std::size_t>(off.size(), 40))),
                      best.hypothesis->look_at});
  } else if (violates(&Invariant::is_of_session)) {
    faults.push_back(
        {"Asked again, it answers otherwise: it remembers something of the collisions before, or depends on how a "
         "request is spelt.",
         "caches, warm starts, what is not reset; the reader of numbers and of fields that are left out"});
  } else if (5 * outcomes.size() > examples.size()) {
    faults.push_back(fault_of(outcomes, result.subject.law));
  }
  if (faults.empty() && !outcomes.empty()) {
    faults.push_back(fault_of(outcomes, result.subject.law));
  }
  Fault joined;
  for (const Fault& fault : faults) {
    joined.what += (joined.what.empty() ? "" : " ") + fault.what;
    joined.look_at += (joined.look_at.empty() ? "" : "; ") + fault.look_at;
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
  const Fault fault = what_is_wrong(result, examples_of(result));
  diagnosis.what = fault.what;
  diagnosis.look_at = fault.look_at;
  diagnosis.where = in_words(where_violated(report, {violated, judged_of(result)}));
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
