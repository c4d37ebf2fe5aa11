// SPDX-License-Identifier: BSL-1.0
#include "law.hpp"

#include <vector>

#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/properties/trial/answers.hpp>
#include <carom/properties/trial/in_words.hpp>
#include <carom/subjects/catalogue.hpp>

#include "case_bytes.hpp"
#include "claimed_domain.hpp"
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

[[noreturn]] void fail_on(const Solver& solver, const Collision& collision, const properties::Invariant& invariant,
                          const properties::Verdict& verdict) {
  const nlohmann::json witness{{"subject", {{"name", solver.subject.name}}},
                               {"invariant", invariant.name},
                               {"collision", collision_to_json(collision)}};
  fail(solver.subject.name + " violates " + std::string(invariant.name) + ": " + properties::in_words(verdict) + '\n' +
       witness.dump());
}

}  // namespace

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
