// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <set>
#include <utility>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/diagnosis/faults.hpp>
#include <carom/properties/gate/in_words.hpp>

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
      for (const auto& [invariant, cases] : family.violated_cases) {
        if (!of_one_answer || invariant->is_of_one_answer()) {
          numbers.insert(cases.begin(), cases.end());
        }
      }
      is_any = is_any || !numbers.empty();
      all.emplace_back(numbers.begin(), numbers.end());
    }
  }
  return all;
}

std::vector<JudgedSample> judged_of(const SubjectResult& result) {
  std::vector<JudgedSample> judged;
  for (const FamilyResult& family : result.families) {
    judged.push_back(
        {result.error.empty() ? family.sampled : std::min(family.sampled, family.cases), family.skipped_cases});
  }
  return judged;
}

std::uint64_t cases_that_violate(const SubjectResult& result, const Invariant* invariant) {
  std::uint64_t sum = 0;
  for (const FamilyResult& family : result.families) {
    const auto found = family.violated_cases.find(invariant);
    sum += found == family.violated_cases.end() ? 0 : found->second.size();
  }
  return sum;
}

/// The first invariant by `rank_as_cause` that nine tenths of the violated cases violate. If there is none, the
/// invariant that is violated most often.
const Invariant* telling_invariant(const SubjectResult& result, std::uint64_t violated) {
  std::vector<const Invariant*> all = result.violated_invariants();
  const auto is_of_relations = [](const Invariant* invariant) { return !invariant->is_of_one_answer(); };
  if (!std::all_of(all.begin(), all.end(), is_of_relations)) {
    // If state spoils every answer, only a repeated question shows the fault. So invariants of the session stay.
    std::erase_if(
        all, [&](const Invariant* invariant) { return is_of_relations(invariant) && !invariant->is_of_session(); });
  }
  std::ranges::stable_sort(all, {}, &Invariant::rank_as_cause);
  constexpr double most = 0.9;
  for (const Invariant* invariant : all) {
    if (static_cast<double>(cases_that_violate(result, invariant)) >= most * static_cast<double>(violated)) {
      return invariant;
    }
  }
  return *std::max_element(all.begin(), all.end(), [&](const Invariant* x, const Invariant* y) {
    return cases_that_violate(result, x) < cases_that_violate(result, y);
  });
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
  diagnosis.faults = faults_of(result, report, {violated, judged_of(result)});
  return diagnosis;
}

std::vector<Diagnosis> diagnose_all(const GateReport& report) {
  std::vector<Diagnosis> diagnoses(report.results.size());
  report.options.workers.run(diagnoses.size(), [&](std::size_t s) {
    if (!is_explained(report.options, s) || report.results[s].violated_invariants().empty()) {
      return;
    }
    const std::string fault = why_failed([&] { diagnoses[s] = diagnose(report.results[s], report); });
    if (!fault.empty()) {
      diagnoses[s].missing = fault;
    }
  });
  return diagnoses;
}

}  // namespace carom::properties::diagnosis
