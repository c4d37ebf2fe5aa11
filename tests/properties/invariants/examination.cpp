// SPDX-License-Identifier: BSL-1.0
#include "examination.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

#include <carom/properties/trial/in_words.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

/// Two unit spheres of mass 1. A hits the resting B along the line of centres.
Case head_on_probe() {
  Case probe;
  probe.collision.a.position = {0, 1, 0};
  probe.collision.a.velocity = {0, -1, 0};
  probe.collision.b.position = {0, -1, 0};
  return probe;
}

bool has_responded(const ExactAnswer& answer, const JudgedCase& judged_case) {
  const auto* outcome = std::get_if<oracles::LiftedOutcome>(&answer);
  if (outcome == nullptr || !judged_case.is_valid() || judged_case.exact().approach() != oracles::Approach::colliding) {
    return false;
  }
  const auto before = unchanged(judged_case.exact().exact());
  bool responded = false;
  for (const OutcomeVector k : all_outcome_vectors) {
    responded = responded || *vectors(outcome->exact())[k] != *vectors(before)[k];
  }
  return responded;
}

std::vector<const Family*> families_of(const Examination& examination) {
  std::vector<const Family*> families;
  for (const Family& family : examination.families) {
    if (examination.structured || family.name != "structured") {
      families.push_back(&family);
    }
  }
  return families;
}

std::optional<std::string> why_nothing_was_tested(bool in_domain, bool responded) {
  if (!in_domain) {
    return "no case of a family was in the domain";
  }
  if (!responded) {
    return "no colliding case of a family was answered with other velocities than before: nothing was tested";
  }
  return std::nullopt;
}

void put(const JudgedCase& judged_case, const Claimant& claimant, bool is_of_family, Seen& seen) {
  const auto& [examinee, invariants] = claimant;
  Claim claim{examinee.law, examinee.yardstick, {}};
  std::copy_if(invariants.begin(), invariants.end(), std::back_inserter(claim.invariants),
               [&](const Invariant* invariant) { return !seen.violated.contains(invariant); });
  if (claim.invariants.empty()) {
    return;
  }
  bool is_first = is_of_family;
  const Judgement judgement = try_case(judged_case, claim, [&, &solve = examinee.solve](const Collision& collision) {
    ExactAnswer answer = solve(collision);
    if (std::exchange(is_first, false)) {
      seen.responded = seen.responded || has_responded(answer, judged_case);
    }
    return answer;
  });
  if (judgement.skipped) {
    seen.violated.insert(claim.invariants.begin(), claim.invariants.end());
  }
  for (const auto& [invariant, verdict] : judgement.verdicts) {
    if (verdict.status == Status::violated) {
      seen.violated.insert(invariant);
    } else if (verdict.status == Status::holds && is_of_family) {
      seen.in_domain.insert(invariant);
    }
  }
}

std::string text_of(const Verdict& verdict) {
  std::ostringstream text;
  text << verdict.detail << ": residual " << verdict.residual << ", allowed " << verdict.allowed << '\n';
  return text.str();
}

}  // namespace

Question invariant_holds(const Invariant& invariant) {
  return [&invariant](const Examinee& examinee, const JudgedCase& judged_case) -> Verdict {
    const Claim claim{examinee.law, examinee.yardstick, {&invariant}};
    const Judgement judgement = try_case(judged_case, claim, examinee.solve);
    if (judgement.skipped) {
      return {Status::violated, "the case could not be posed: " + judgement.skipped->why, 0, 0, {}, {}};
    }
    if (judgement.verdicts.empty()) {
      return {Status::skipped, "the invariant does not speak of such cases", 0, 0, {}, {}};
    }
    return judgement.verdicts.front().verdict;
  };
}

std::optional<std::string> find_violation(const Examinee& examinee, const Question& question,
                                          const Examination& examination) {
  bool in_domain = false;
  bool responded = false;
  const auto put = [&](const Case& one) {
    const JudgedCase judged_case(one);
    Verdict verdict = question(examinee, judged_case);
    in_domain = in_domain || verdict.status == Status::holds;
    responded = responded || has_responded(examinee.solve(one.collision), judged_case);
    return verdict;
  };
  const Verdict of_probe = question(examinee, JudgedCase(head_on_probe()));
  if (of_probe.status == Status::violated) {
    return "on the head-on probe: " + text_of(of_probe);
  }
  for (const Family* family : families_of(examination)) {
    for (std::uint64_t i = 0; i < examination.cases; ++i) {
      const Case one = unit::case_of(family->name, i);
      const Verdict verdict = put(one);
      if (verdict.status == Status::violated) {
        return "in the family " + std::string(family->name) + ": " + text_of(verdict) + in_words(one.collision, "");
      }
    }
  }
  return why_nothing_was_tested(in_domain, responded);
}

std::vector<Seen> examine(std::span<const Claimant> claimants, const Examination& examination) {
  std::vector<Seen> seen(claimants.size());
  const auto put_to_all = [&](const Case& one, bool is_of_family) {
    const JudgedCase judged_case(one);
    for (std::size_t i = 0; i < claimants.size(); ++i) {
      put(judged_case, claimants[i], is_of_family, seen[i]);
    }
  };
  put_to_all(head_on_probe(), false);
  for (const Family* family : families_of(examination)) {
    for (std::uint64_t i = 0; i < examination.cases; ++i) {
      put_to_all(unit::case_of(family->name, i), true);
    }
  }
  return seen;
}

std::optional<std::string> found_by(const Seen& seen, const Claimant& claimant, const Invariant& invariant,
                                    const Examination& examination) {
  if (seen.violated.contains(&invariant)) {
    return find_violation(claimant.examinee, invariant_holds(invariant), examination)
        .value_or("a violation that is not found again");
  }
  return why_nothing_was_tested(seen.in_domain.contains(&invariant), seen.responded);
}

}  // namespace carom::properties
