// SPDX-License-Identifier: BSL-1.0
#include <vector>

#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/bounds/moderate.hpp>
#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/subjects/catalogue.hpp>

#include "case_bytes.hpp"
#include "target.hpp"

namespace carom::fuzz {
namespace {

struct Solver {
  Subject subject;
  properties::Claim claim;
  Session session;
};

std::vector<Solver> solvers_of(Law law) {
  std::vector<Solver> solvers;
  for (const Subject& subject : subjects::built_in_subjects()) {
    if (subject.law == law && subject.precision == Precision::binary64 && subject.expected_to_pass) {
      solvers.push_back({subject, properties::claim_of(subject, {}), subject.open()});
    }
  }
  return solvers;
}

/// Whether Carom's binary64 solvers of the law claim to be sound on a collision that no family drew. The collision's
/// numbers must be moderate (moderate.hpp). No body may be more slender than those of the family `physical`. Laws that
/// invert the collision matrix K also require K ⪯ 16 λI, with λ = 1/m_A + 1/m_B. This bound holds for bodies of uniform
/// density that are star-shaped from the contact point, such as convex bodies. Precondition: the collision is valid.
bool is_in_claimed_domain(const Collision& collision, Law law) {
  constexpr double largest_ratio_of_moments = 1e8;
  // The collision matrix is K = λI + T, with λ = 1/m_A + 1/m_B and the response to torque T = Σ [r]ᵀ J⁻¹ [r]. So K ⪯ 16
  // λI means T ⪯ 15 λI. This function requires T ⪯ 14.5 λI, so that its rounding errors do not matter.
  constexpr double largest_response_to_torque = 14.5;
  if (!oracles::is_moderate(collision)) {
    return false;
  }
  double inverse_mass = 0;
  double response_to_torque = 0;  // an upper bound of ‖T‖
  for (const Body* body : {&collision.a, &collision.b}) {
    if (body->immovable) {
      continue;
    }
    const double least_moment = body->principal_inertia.minCoeff();
    if (body->principal_inertia.maxCoeff() > largest_ratio_of_moments * least_moment) {
      return false;
    }
    inverse_mass += 1 / body->mass;
    response_to_torque += (collision.point - body->position).squaredNorm() / least_moment;
  }
  return law == Law::frictionless || response_to_torque <= largest_response_to_torque * inverse_mass;
}

[[noreturn]] void fail_on(const Solver& solver, const Collision& collision, const properties::Invariant& invariant,
                          const properties::Verdict& verdict) {
  const nlohmann::json witness{{"subject", {{"name", solver.subject.name}}},
                               {"invariant", invariant.name},
                               {"collision", collision_to_json(collision)}};
  fail(solver.subject.name + " violates " + std::string(invariant.name) + ": " + properties::in_words(verdict) + '\n' +
       witness.dump());
}

}  // namespace

/// Gives a case to a sound built-in solver of the law in double, and judges the answer on every invariant of the law.
/// The first byte selects the solver; the case follows. The target prints a violation as a witness that `carom replay`
/// reads. Beyond the claimed domain, a violation is no finding, but a refusal or two different
/// answers to one case are findings.
void judge_law(Bytes bytes, Law law) {
  static std::vector<Solver> solvers = solvers_of(law);
  Input input(bytes);
  Solver& solver = solvers[input.byte() % solvers.size()];
  const ReadCase read = case_from(input);
  const Collision& collision = read.one.collision;
  const std::vector<Answer> first = properties::answers_of(solver.session, std::span(&collision, 1));
  const bool is_valid = validate(collision).empty();
  const bool is_beyond_domain = !read.is_of_family && is_valid && !is_in_claimed_domain(collision, law);
  require(!is_valid || !std::holds_alternative<Refused>(first[0]), "a valid collision was refused");
  const properties::AnswerAndJudgement judged = properties::judge_in_session(solver.claim, solver.session, read.one);
  for (const properties::NamedVerdict& named : judged.judgement.verdicts) {
    if (named.verdict.status == properties::Status::violated && !is_beyond_domain) {
      fail_on(solver, collision, *named.invariant, named.verdict);
    }
  }
  for (const properties::Invariant* invariant : solver.claim.invariants) {
    if (const auto* about = std::get_if<properties::AboutSession>(&invariant->about)) {
      const properties::Verdict verdict =
          about->check(first[0], judged.answer, properties::sameness_of_answers(solver.subject));
      if (verdict.status == properties::Status::violated) {
        fail_on(solver, collision, *invariant, verdict);
      }
    }
  }
}

}  // namespace carom::fuzz
