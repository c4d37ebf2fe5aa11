// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/frictionless.hpp>
#include <carom/properties/kit/finding.hpp>
#include <carom/properties/kit/subject.hpp>

#include "support/expect_in.hpp"

/// The kit's tests pass for sound solvers, and fail for faulty ones.
namespace carom::conformance {
namespace {

using properties::Status;

Finding find(const Subject& subject, std::string_view invariant, const std::string& family, Options options = {}) {
  options.families = {family};
  for (const Statement& statement : statements(subject, options)) {
    if (statement.invariant->name == invariant) {
      return conformance::find(statement);
    }
  }
  throw std::invalid_argument(std::string(invariant) + " is not claimed");
}

Subject frictionless() { return subject("frictionless", Law::frictionless, impulse::frictionless<double>); }

Subject bouncing_twice() {
  return subject("bouncing", Law::frictionless, [](impulse::Contact<double> contact) {
    contact.restitution *= 2;
    return impulse::frictionless(contact);
  });
}

TEST(Finding, IsASkipWhereNoCaseIsInTheDomain) {
  const Finding finding = find(frictionless(), "restitution", "resting");
  EXPECT_EQ(finding.status, Status::skipped);
  unit::expect_in(finding.text,
                  {"no case of resting is in the domain of restitution (colliding contacts); first case: the "
                   "contact is not colliding"});
}

TEST(Finding, IsASkipOfAnAbsentSubject) {
  Subject absent = frictionless();
  absent.absent = "not installed";
  absent.open = nullptr;
  const Finding finding = find(absent, "finite", "generic");
  EXPECT_EQ(finding.status, Status::skipped);
  unit::expect_in(finding.text, {"not installed"});
}

TEST(Finding, ShowsTheShrunkWitnessInWords) {
  const Finding finding = find(bouncing_twice(), "restitution", "generic");
  EXPECT_EQ(finding.status, Status::violated);
  unit::expect_in(finding.text, {"bouncing violates restitution in generic; shrunk:\n",
                                 "  The normal velocity is reversed and multiplied by ε.\n",
                                 "    A: mass 1, principal inertia (1, 1, 1), orientation (1, 0, 0, 0), at (0, 0, 0), ",
                                 "restitution 1\n", "  answered\n", "  N·V⁺ and −ε N·V⁻: 2 and 1, apart by 1, allowed ",
                                 "  for `carom replay FILE`: {\"a\":"});
}

TEST(Finding, NamesWhatASubjectThrew) {
  const Subject throwing = subject("", Law::any, [](const Collision& collision) -> Outcome<double> {
    if (collision.a.mass > 0) {
      throw std::runtime_error("no convergence");
    }
    return unchanged(collision);
  });
  const Finding finding = find(throwing, "restitution", "generic");
  EXPECT_EQ(finding.status, Status::violated);
  unit::expect_in(finding.text, {"ends in generic; shrunk:\n", "the subject threw: no convergence", "    A: mass 1, "});
  // The other tests of the suite do not repeat it.
  int failed = 0;
  for (const Statement& statement : statements(throwing, {.families = {"generic", "resting"}})) {
    const Finding other = conformance::find(statement, "Name");
    failed += other.status == Status::violated ? 1 : 0;
    EXPECT_NE(other.status, Status::holds);
    unit::expect_in(other.text, {"the subject threw: no convergence"});
  }
  EXPECT_EQ(failed, 1);
}

Subject answering_nan() {
  return subject("lost", Law::frictionless, [](const Collision& collision) {
    Outcome<double> outcome = unchanged(collision);
    outcome.a.velocity[2] = std::nan("");
    return outcome;
  });
}

TEST(Finding, NamesNanAsTheReason) {
  const Finding finite = find(answering_nan(), "finite", "generic");
  EXPECT_EQ(finite.status, Status::violated);
  unit::expect_in(finite.text, {"the outcome contains infinities or NaN", "Its answer contains infinities or NaN in "});
  const Finding other = find(answering_nan(), "restitution", "near_head_on");
  EXPECT_EQ(other.status, Status::skipped);
  unit::expect_in(other.text, {"restitution judged no case of near_head_on: the answer contains infinities or NaN"});
}

TEST(Finding, HasTheDiagnosisOfTheGateOnce) {
  std::string first;
  for (const Statement& statement : statements(bouncing_twice(), {.families = {"generic", "elastic"}})) {
    const Finding finding = conformance::find(statement, "Name");
    if (finding.status != Status::violated) {
      continue;
    }
    if (!first.empty()) {
      unit::expect_in(finding.text, {"  The diagnosis stands in the message of Name.\n"});
      return;
    }
    first = finding.text;
    const std::string diagnosis = first.substr(first.find("  The gate's diagnosis, of "));
    unit::expect_in(diagnosis, {"It answers as if ", "    Look at: "});
    EXPECT_LE(std::count(diagnosis.begin(), diagnosis.end(), '\n'), 10) << diagnosis;
  }
  FAIL() << "fewer than two tests fail";
}

TEST(Finding, IsNoneIfTheJudgeFails) {
  properties::Invariant broken = *properties::invariant_named("restitution");
  broken.about = properties::AboutOutcome{
      [](const properties::Evidence&) -> properties::Verdict { throw std::logic_error("a wrong formula"); }};
  Statement statement = statements(frictionless(), {.families = {"generic"}}).at(0);
  statement.invariant = &broken;
  EXPECT_THROW((void)conformance::find(statement), oracles::JudgeError);
}

/// A suite's subject that holds its cases against a domain.
Subject within(const properties::Domain& domain, int& outside) {
  return subject("", Law::frictionless, [&outside, domain](const Collision& collision) {
    outside += contains(domain, collision) ? 0 : 1;
    return impulse::frictionless(impulse::make_contact<double>(collision));
  });
}

TEST(Finding, ComesFromCasesInTheDomainOfTheSuite) {
  const properties::Domain games = *properties::domain_named("games");
  int outside = 0;
  for (const char* invariant : {"restitution", "homogeneous", "memoryless"}) {
    EXPECT_EQ(find(within(games, outside), invariant, "generic", {.within = "games"}).status, Status::holds);
  }
  EXPECT_EQ(outside, 0);
  EXPECT_EQ(find(within(games, outside), "restitution", "generic").status, Status::holds);
  EXPECT_GT(outside, 0);
  Subject declaring = within(games, outside = 0);
  declaring.domain = to_text(games);
  EXPECT_EQ(find(declaring, "restitution", "generic").status, Status::holds);
  EXPECT_EQ(outside, 0);
}

TEST(Finding, FollowsDigitsAndEffects) {
  const Subject rounding = subject("", Law::frictionless, [](const impulse::Contact<double>& contact) {
    return map_outcome<double>(impulse::frictionless(contact), [](double x) { return x * (1 + 1e-9); });
  });
  EXPECT_EQ(find(rounding, "restitution", "generic").status, Status::violated);
  EXPECT_EQ(find(rounding, "restitution", "generic", {.digits = 4}).status, Status::holds);
  const Subject slow = subject("", Law::frictionless, [](Collision collision) {
    const double approach = -properties::relative_velocity(collision).dot(collision.normal);
    collision.restitution = approach < 0.5 * collision.normal.norm() ? 0 : collision.restitution;
    return impulse::frictionless(impulse::make_contact<double>(collision));
  });
  EXPECT_EQ(find(slow, "restitution", "elastic").status, Status::violated);
  EXPECT_EQ(find(slow, "restitution", "elastic", {.effects = {{"restitution_threshold", 0.5}}}).status, Status::holds);
}

Finding judged(const Subject& subject, const std::vector<std::string>& families) {
  return finding_of_judged(statements(subject, {.families = families}), "Name");
}

TEST(JudgedInvariants, AreAllOfThem) {
  EXPECT_EQ(judged(frictionless(), {}).status, Status::holds);
  const Finding resting = judged(frictionless(), {"resting"});
  EXPECT_EQ(resting.status, Status::violated);
  unit::expect_in(resting.text, {"Some invariants are judged on no case of any family:\n",
                                 "  no case of resting is in the domain of restitution (colliding contacts)"});
  const Finding nan = judged(answering_nan(), {"generic"});
  EXPECT_EQ(nan.status, Status::violated);
  unit::expect_in(nan.text, {"restitution judged no case of generic: the answer contains infinities or NaN"});
  Subject skipping = frictionless();
  skipping.open = [] {
    return
        [](std::span<const Collision> collisions) { return std::vector<Answer>(collisions.size(), Skipped{"tired"}); };
  };
  unit::expect_in(judged(skipping, {"generic"}).text,
                  {"finite judged no case of generic: the subject skipped the case: tired"});
}

TEST(Finding, TellsThatASubjectKeepsState) {
  const Subject tiring = subject("", Law::any, [is_tired = false](const Collision& collision) mutable {
    Outcome<double> outcome = unchanged(collision);
    const Vector3<double> v = properties::relative_velocity(collision);
    if (!is_tired && v.dot(collision.normal) > 1) {
      is_tired = true;
      outcome.a.velocity[0] += 1;
      outcome.b.velocity[0] += 1;
    }
    return outcome;
  });
  const Finding finding = find(tiring, "separating_untouched", "separating");
  EXPECT_EQ(finding.status, Status::violated);
  unit::expect_in(finding.text, {"it keeps state from earlier collisions"});
}

}  // namespace
}  // namespace carom::conformance
