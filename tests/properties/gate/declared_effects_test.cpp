// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/laws/mechanics.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/suggested_effects.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/subjects/session.hpp>

#include "io/threads.hpp"
#include "support/cases.hpp"
#include "support/changed_subject.hpp"
#include "support/expect_in.hpp"
#include "support/message_of.hpp"

namespace carom::properties {
namespace {

DeclaredEffects only(DeclaredEffect effect, double size) {
  DeclaredEffects effects;
  effects[effect] = size;
  return effects;
}

double approach_speed(const Collision& c) { return -oracles::normal_velocity_before(c) / c.normal.stableNorm(); }

template <class S>
void damp_and_limit(Vector3<S>& velocity, double damping, double limit) {
  velocity *= S(1) - S(damping);
  const S length = velocity.stableNorm();
  if (limit > 0 && length > S(limit)) {
    velocity *= S(limit) / length;
  }
}

Answer with_effects(Session& session, Collision c, const DeclaredEffects& effects) {
  const double approach = approach_speed(c);
  if (approach > 0 && approach < effects[DeclaredEffect::restitution_threshold]) {
    c.restitution = 0;
  }
  Answer answer = session(std::span(&c, 1)).at(0);
  auto* outcome = std::get_if<ReportedOutcome>(&answer);
  if (outcome == nullptr) {
    return answer;
  }
  if (approach > 0 && approach < effects[DeclaredEffect::slop]) {
    *outcome = reported(unchanged(c));
  }
  const auto change = [&](const Body& body, BodyVelocity<long double>& motion) {
    if (!body.immovable) {
      damp_and_limit(motion.velocity, effects[DeclaredEffect::linear_damping], effects[DeclaredEffect::max_speed]);
      damp_and_limit(motion.angular_velocity, effects[DeclaredEffect::angular_damping],
                     effects[DeclaredEffect::max_angular_velocity]);
    }
  };
  change(c.a, outcome->a);
  change(c.b, outcome->b);
  const auto matrix = outcome->collision_matrix;
  *outcome = reported(map_outcome<double>(*outcome, [](long double x) { return static_cast<double>(x); }));
  outcome->collision_matrix = matrix;
  return answer;
}

/// A built-in solver with the effects `done`, which declares the effects `declared`.
Subject with_effects(const std::string& solver, const DeclaredEffects& done, const DeclaredEffects& declared) {
  Subject subject = unit::subject_of(solver);
  subject.effects = declared;
  subject.open = [done, open = subject.open]() -> Session {
    return subjects::session_of([done, session = open()](const Collision& collision) mutable {
      return with_effects(session, collision, done);
    });
  };
  return subject;
}

GateReport report_on(const Subject& subject, const char* only_family = nullptr) {
  GateOptions options = only_family == nullptr ? unit::gate_options(static_cast<std::uint64_t>(unit::effort(5)))
                                               : unit::gate_options(10, {only_family});
  options.workers = tool::threads(2);
  options.shrinks = false;
  return run_gate({subject}, options);
}

SubjectResult judged(const Subject& subject, const char* only_family = nullptr) {
  return report_on(subject, only_family).results.at(0);
}

/// A size of each effect that changes many cases.
constexpr DeclaredEffects sizes{{{0.5, 0.25, 0.01, 0.02, 2, 3}}};

void expect_sound(const char* solver, const DeclaredEffects& effects) {
  const SubjectResult result = judged(with_effects(solver, effects, effects));
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(names_of(result.violated_invariants()), std::vector<std::string>{}) << solver << ", " << to_text(effects);
}

TEST(DeclaredEffects, AreJudgedWithoutThem) {
  std::vector<DeclaredEffects> all;
  for (const DeclaredEffect effect : all_declared_effects) {
    all.push_back(only(effect, sizes[effect]));
  }
  all.push_back(sizes);
  for (const DeclaredEffects& effects : all) {
    for (const char* solver : {"reflection-double", "frictionless-float"}) {
      expect_sound(solver, effects);
    }
  }
  expect_sound("rough-double", sizes);
}

TEST(DeclaredEffects, AreViolationsIfTheyAreNotDeclared) {
  for (const DeclaredEffect effect : all_declared_effects) {
    const SubjectResult result = judged(with_effects("reflection-double", only(effect, sizes[effect]), {}));
    EXPECT_FALSE(result.violated_invariants().empty()) << name_of(effect);
  }
}

TEST(DeclaredEffects, AreSuggestedWithTheirSizes) {
  for (const char* solver : {"reflection-double", "frictionless-float"}) {
    for (const DeclaredEffect effect : all_declared_effects) {
      const DeclaredEffects done = only(effect, sizes[effect]);
      GateOptions options = unit::gate_options(30);
      options.workers = tool::threads(2);
      options.shrinks = false;
      const GateReport report = run_gate({with_effects(solver, done, {})}, options);
      EXPECT_EQ(to_text(suggested_effects(report.results.at(0), report)), to_text(done)) << solver;
    }
  }
}

TEST(DeclaredEffects, AreViolationsIfTheirSizeIsWrong) {
  for (const DeclaredEffect effect : all_declared_effects) {
    const DeclaredEffects done = only(effect, sizes[effect]);
    // A wrong threshold shows only in contacts that approach at a speed between both thresholds.
    const double factor = depend_on_approach(done) ? 2 : 1.02;
    for (const double declared : {sizes[effect] / factor, sizes[effect] * factor}) {
      const SubjectResult result = judged(with_effects("reflection-double", done, only(effect, declared)));
      EXPECT_FALSE(result.violated_invariants().empty()) << name_of(effect) << ' ' << declared;
    }
  }
}

TEST(DeclaredEffects, DoNotHideAnotherDefect) {
  for (const DeclaredEffect effect : all_declared_effects) {
    const DeclaredEffects effects = only(effect, sizes[effect]);
    const SubjectResult result = judged(with_effects("reflection-world-double", effects, effects), "structured");
    EXPECT_FALSE(result.violated_invariants().empty()) << name_of(effect);
  }
}

TEST(DeclaredEffects, AreTakenOutBeforeTheDiagnosis) {
  DeclaredEffects damping;
  damping[DeclaredEffect::linear_damping] = damping[DeclaredEffect::angular_damping] = 0.5;
  const Subject subject = unit::misreading(with_effects("frictionless-double", damping, damping),
                                           [](Collision& collision) { collision.restitution = 0; });
  const GateReport report = report_on(subject, "structured");
  const std::vector<diagnosis::Fault> faults = diagnosis::diagnose(report.results.at(0), report).faults;
  ASSERT_EQ(faults.size(), 1U);
  unit::expect_in(faults[0].what, {"as if ε were 0"});
}

TEST(DeclaredEffects, OfApproachChangeTheJudgedCollision) {
  Collision c;
  c.a.velocity = {0, -1, 0};
  c.b.immovable = true;
  c.normal = {0, 2, 0};  // only its direction matters
  c.restitution = 0.5;
  const auto judged = [&](DeclaredEffect effect, double size) { return judged_collision(c, only(effect, size)); };
  EXPECT_EQ(judged(DeclaredEffect::restitution_threshold, 1.001).restitution, 0);
  EXPECT_EQ(judged(DeclaredEffect::restitution_threshold, 0.999).restitution, 0.5);
  EXPECT_EQ(judged(DeclaredEffect::slop, 1.001).normal, (Vector3<double>{0, -2, 0}));
  EXPECT_EQ(judged(DeclaredEffect::slop, 0.999).normal, c.normal);
  c.a.velocity = {0, 1, 0};
  EXPECT_EQ(judged(DeclaredEffect::slop, 2).normal, c.normal);
  EXPECT_EQ(judged(DeclaredEffect::restitution_threshold, 2).restitution, 0.5);
}

TEST(DeclaredEffects, AreNotJudgedAtTheirLimit) {
  Case one;
  Collision& c = one.collision;
  c.a.velocity = {0, -0.5, 0};
  c.b.immovable = true;
  c.normal = {0, 1, 0};
  c.restitution = 0.5;
  auto yardstick = oracles::Yardstick::of(Precision::binary64);
  const auto reason = [&](double threshold) {
    return JudgedCase(one, true, only(DeclaredEffect::restitution_threshold, threshold)).reason_unjudged_by(yardstick);
  };
  EXPECT_EQ(reason(0.5), Unjudged::at_declared_limit);
  EXPECT_EQ(reason(0.5 + 0x1p-50), Unjudged::at_declared_limit);
  EXPECT_EQ(reason(0.5 + 0x1p-40), std::nullopt);
  yardstick = oracles::Yardstick::of(Precision::binary64,
                                     {.digits = 3});  // inputs are not rounded more because an answer may be
  EXPECT_EQ(reason(0.5 + 0x1p-50), Unjudged::at_declared_limit);
  EXPECT_EQ(reason(0.5 + 0x1p-40), std::nullopt);
  c.restitution = 0;  // the threshold changes nothing
  EXPECT_EQ(reason(0.5), std::nullopt);
}

GateOptions options_within(const char* within, std::uint64_t cases = 20) {
  GateOptions options = unit::gate_options(cases, {"generic", "physical"});
  options.within = domain_from(within);
  options.is_part = true;
  options.shrinks = false;
  return options;
}

std::string why_not_judged(const Subject& subject, const GateOptions& options) {
  const SubjectResult result = run_gate({subject}, options).results.at(0);
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(names_of(result.violated_invariants()), std::vector<std::string>{});
  EXPECT_EQ(result.is_sound(), result.not_judged.empty());
  return result.not_judged;
}

/// The domain that the message names.
std::string domain_in(const std::string& why) {
  const std::string option = "--within ";
  const std::size_t at = why.find(option);
  return at == std::string::npos ? "" : why.substr(at + option.size());
}

/// All contacts approach at the threshold, so no outcome is judged.
TEST(DeclaredEffects, LeaveASubjectWithoutAVerdictIfMostCasesLieAtALimit) {
  Subject subject = unit::subject_of("frictionless-double");
  subject.effects = only(DeclaredEffect::restitution_threshold, 0.5);
  GateOptions options = options_within("");
  options.families = {family_named("elastic")};
  options.within.ranges[LimitedQuantity::approach] = {0.5 - 0x1p-49, 0.5 + 0x1p-49};
  const std::string why = why_not_judged(subject, options);
  EXPECT_EQ(why.find("the declared restitution_threshold 0.5 m/s decides 20 of 20 colliding cases"), 0U) << why;
}

/// The solver has the effects that it declares, so it violates nothing.
TEST(DeclaredEffects, ThatDecideMoreThanATenthLeaveASubjectWithoutAVerdict) {
  for (const DeclaredEffect effect : {DeclaredEffect::restitution_threshold, DeclaredEffect::slop,
                                      DeclaredEffect::max_speed, DeclaredEffect::max_angular_velocity}) {
    const DeclaredEffects effects = only(effect, 2);
    const Subject subject = with_effects("frictionless-double", effects, effects);
    const std::string why = why_not_judged(subject, options_within("", 40));
    EXPECT_EQ(why.find("the declared " + to_text(effects) + " decides "), 0U) << why;
    const std::string domain = domain_in(why);
    ASSERT_NE(domain, "") << why;
    EXPECT_EQ(why_not_judged(subject, options_within(domain.c_str(), 40)), "") << domain;
  }
}

TEST(DeclaredEffects, HaveADomainInsideThatOfTheRun) {
  const DeclaredEffects effects = only(DeclaredEffect::restitution_threshold, 2);
  const Subject subject = with_effects("frictionless-double", effects, effects);
  EXPECT_EQ(domain_in(why_not_judged(subject, options_within("size=0.1:10,approach=1:8"))), "size=0.1:10,approach=2:8");
  const std::string why = why_not_judged(subject, options_within("approach=0.1:1.5"));
  unit::expect_in(why, {"no domain was found in which it decides less"});
}

/// A slop of this size excuses every answer.
TEST(DeclaredEffects, DoNotExcuseASolverThatDoesNothing) {
  Subject idle = unit::idle_subject();
  idle.effects = only(DeclaredEffect::slop, 1e300);
  const std::string why = why_not_judged(idle, options_within(""));
  EXPECT_EQ(why.find("the declared slop 1e+300 m/s decides "), 0U) << why;
  const GateReport faster = run_gate({idle}, options_within(domain_in(why).c_str()));
  EXPECT_GT(faster.results.at(0).count(*invariant_named("restitution")).violated, 0U) << why;
}

/// Damping hides nothing, because the gate divides the answer by what damping keeps of it.
TEST(DeclaredEffects, OfDampingDecideNoCase) {
  DeclaredEffects damping;
  damping[DeclaredEffect::linear_damping] = damping[DeclaredEffect::angular_damping] = 1 - 0x1p-53;
  const SubjectResult right = judged(with_effects("frictionless-double", damping, damping));
  EXPECT_TRUE(right.is_sound()) << right.not_judged;
  EXPECT_EQ(right.decided_by(), EffectCounts{});
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    Subject zeros =
        unit::with_answers(with_effects("frictionless-double", damping, damping),
                           [](const auto&, auto& answers) { std::ranges::fill(answers, Answer(ReportedOutcome())); });
    zeros.precision = precision;
    const SubjectResult wrong = judged(zeros);
    EXPECT_GT(wrong.count(*invariant_named("backward_error")).violated, 0U);
    EXPECT_GT(wrong.count(*invariant_named("separating_untouched")).violated, 0U);
  }
}

/// A twentieth of the cases may lie below a threshold.
TEST(DeclaredEffects, ThatDecideFewCasesAreJudged) {
  const DeclaredEffects effects = only(DeclaredEffect::restitution_threshold, 1e-6);
  const Subject subject = with_effects("frictionless-double", effects, effects);
  const SubjectResult result = judged(subject);
  EXPECT_TRUE(result.is_sound()) << result.not_judged;
  EXPECT_GT(result.decided_by()[DeclaredEffect::restitution_threshold], 0U);
}

TEST(DeclaredEffects, AreRefusedIfTheyAreNotValid) {
  const auto why = [](DeclaredEffect effect, double size, Law law) {
    return unit::message_of<std::invalid_argument>([&] { require_valid(only(effect, size), law); });
  };
  EXPECT_EQ(why(DeclaredEffect::slop, 0.1, Law::any), "");
  EXPECT_EQ(why(DeclaredEffect::max_speed, 10, Law::rough), "");
  EXPECT_EQ(why(DeclaredEffect::slop, -1, Law::any), "slop: expected a positive number, found -1");
  EXPECT_EQ(why(DeclaredEffect::linear_damping, 1, Law::any),
            "linear_damping: expected a positive number below 1, found 1");
  EXPECT_EQ(why(DeclaredEffect::max_speed, 10, Law::coulomb),
            "a limit of speeds needs a law that determines the outcome; coulomb does not");
}

}  // namespace
}  // namespace carom::properties
