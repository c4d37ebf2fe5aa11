// SPDX-License-Identifier: BSL-1.0
#include "examination.hpp"

#include <sstream>

#include <carom/properties/trial/in_words.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

/// Two unit spheres of mass 1, one at rest, hit along the line of centres.
Case head_on_probe() {
  Case probe;
  probe.collision.a.position = {0, 1, 0};
  probe.collision.a.velocity = {0, -1, 0};
  probe.collision.b.position = {0, -1, 0};
  return probe;
}

bool has_responded(const Examinee& examinee, const JudgedCase& judged_case) {
  if (!judged_case.is_valid() || judged_case.exact().approach() != oracles::Approach::colliding) {
    return false;
  }
  const ExactAnswer answer = examinee.solve(judged_case.generated().collision);
  const auto* outcome = std::get_if<oracles::LiftedOutcome>(&answer);
  if (outcome == nullptr) {
    return false;
  }
  const auto before = unchanged(judged_case.exact().exact());
  bool responded = false;
  for (const OutcomeVector k : all_outcome_vectors) {
    responded = responded || *vectors(outcome->exact())[k] != *vectors(before)[k];
  }
  return responded;
}

std::string text_of(const Verdict& verdict) {
  std::ostringstream text;
  text << verdict.detail << ": residual " << verdict.residual << ", allowed " << verdict.allowed << '\n';
  return text.str();
}

}  // namespace

Question invariant_holds(const Invariant& invariant) {
  return [&invariant](const Examinee& examinee, const JudgedCase& judged_case) -> Verdict {
    const Claim claim{examinee.model, examinee.yardstick, {&invariant}};
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
    responded = responded || has_responded(examinee, judged_case);
    return verdict;
  };
  const Verdict of_probe = question(examinee, JudgedCase(head_on_probe()));
  if (of_probe.status == Status::violated) {
    return "on the head-on probe: " + text_of(of_probe);
  }
  for (const Family& family : examination.families) {
    if (family.name == "structured" && !examination.structured) {
      continue;
    }
    for (std::uint64_t i = 0; i < examination.cases; ++i) {
      const Case one = unit::case_of(family.name, i);
      const Verdict verdict = put(one);
      if (verdict.status == Status::violated) {
        return "in the family " + std::string(family.name) + ": " + text_of(verdict) + in_words(one.collision, "");
      }
    }
  }
  if (!in_domain) {
    return "no case of a family was in the domain";
  }
  if (!responded) {
    return "no colliding case of a family was answered with other velocities than before: nothing was tested";
  }
  return std::nullopt;
}

}  // namespace carom::properties
