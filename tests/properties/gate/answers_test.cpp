// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/gate.hpp>

#include "support/changed_subject.hpp"
#include "support/expect_in.hpp"

/// Subjects that fail, and subjects whose answer to a collision depends on earlier calls, or on chance.
namespace carom::properties {
namespace {

/// A subject that fails on every collision whose restitution is 1. Counts how often the gate opens it.
Subject fragile(int& opened, int most_opened = 1000) {
  Subject subject;
  subject.name = "fragile";
  subject.open = [&opened, most_opened]() -> Session {
    if (opened == most_opened) {
      throw std::runtime_error("there is no more of it");
    }
    ++opened;
    return Session([](std::span<const Collision> collisions) {
      std::vector<Answer> answers;
      for (const Collision& collision : collisions) {
        if (collision.restitution == 1) {
          throw SessionFailure("solve: broke", answers, {"broke"});
        }
        answers.emplace_back(Refused{"sound"});
      }
      return answers;
    });
  };
  return subject;
}

std::vector<Collision> collisions(std::initializer_list<double> restitutions) {
  std::vector<Collision> all;
  for (const double restitution : restitutions) {
    all.emplace_back().restitution = restitution;
  }
  return all;
}

TEST(Restarts, AnswerAFailureAndAskTheOtherCollisions) {
  int opened = 0;
  Restarts restarts(10);
  Session session = open_restarting(fragile(opened), restarts);
  const std::vector<Answer> answers = session(collisions({1, 0, 0, 1, 1, 0, 1}));
  ASSERT_EQ(answers.size(), 7U);
  for (const std::size_t failed : {0U, 3U, 4U, 6U}) {
    EXPECT_EQ(std::get<Failed>(answers[failed]).why, "broke");
  }
  for (const std::size_t sound : {1U, 2U, 5U}) {
    EXPECT_EQ(std::get<Refused>(answers[sound]).why, "sound");
  }
  EXPECT_EQ(opened, 5);
  EXPECT_FALSE(restarts.are_spent());
}

TEST(Restarts, EndAfterTheGivenNumberOfFailures) {
  int opened = 0;
  Restarts restarts(2);
  Session session = open_restarting(fragile(opened), restarts);
  try {
    (void)session(collisions({0, 1, 0, 1, 0}));
    FAIL() << "it may fail once, and fails twice";
  } catch (const SessionFailure& failure) {
    EXPECT_EQ(failure.answered().size(), 4U) << "what was answered until then, the failures with it";
    unit::expect_in(std::string(failure.what()), {"failed 2 times"});
  }
  EXPECT_TRUE(restarts.are_spent());
  EXPECT_THROW((void)session(collisions({0})), std::runtime_error);
}

TEST(Restarts, EndAfterTheGivenTimeOfFailures) {
  Restarts restarts(1000, std::chrono::seconds(10));
  EXPECT_TRUE(restarts.may_restart_after(std::chrono::seconds(9)));
  EXPECT_FALSE(restarts.may_restart_after(std::chrono::seconds(2)));
}

TEST(Restarts, TellWhyASubjectCannotStartAgain) {
  int opened = 0;
  Restarts restarts(10);
  Session session = open_restarting(fragile(opened, 1), restarts);
  try {
    (void)session(collisions({0, 1, 0}));
    FAIL() << "it cannot be opened twice";
  } catch (const SessionFailure& failure) {
    EXPECT_EQ(failure.answered().size(), 2U);
    unit::expect_in(std::string(failure.what()), {"there is no more of it"});
  }
}

TEST(Restarts, DoNotCountAStopAsAFailure) {
  int opened = 0;
  Restarts restarts(10);
  std::stop_source stop;
  Session session = open_restarting(fragile(opened), restarts, stop.get_token());
  stop.request_stop();
  EXPECT_THROW((void)session(collisions({1})), SessionFailure);
  EXPECT_EQ(opened, 1);
  EXPECT_TRUE(restarts.may_restart_after(std::chrono::seconds(0)));
}

enum class Remembers { nothing, a_refusal, the_call, the_last_outcome };

Subject remembering(Remembers what) {
  struct State {
    bool refused = false;
    std::uint64_t calls = 0;
    bool has_answered = false;
  };
  return unit::with_answers(unit::subject_of("frictionless-double"),
                            [what, state = State()](const auto&, std::vector<Answer>& answers) mutable {
                              for (Answer& answer : answers) {
                                ++state.calls;
                                auto* outcome = std::get_if<ReportedOutcome>(&answer);
                                if (outcome == nullptr) {
                                  state.refused = true;
                                  continue;
                                }
                                const bool is_off = (what == Remembers::a_refusal && state.refused) ||
                                                    (what == Remembers::the_call && state.calls % 7 == 0) ||
                                                    (what == Remembers::the_last_outcome && state.has_answered);
                                state.refused = false;
                                state.has_answered = true;
                                if (is_off) {
                                  // An error of one ulp violates only `memoryless`.
                                  long double& component = outcome->a.velocity[0];
                                  component = std::nextafter(static_cast<double>(component), 1e300);
                                }
                              }
                            });
}

SubjectResult judged(Remembers what) {
  GateOptions options = unit::gate_options(100, {"generic"});
  options.is_part = true;
  return run_gate({remembering(what)}, options).results.at(0);
}

TEST(Memoryless, IsViolatedByWhatASessionKeeps) {
  for (const Remembers what : {Remembers::a_refusal, Remembers::the_call, Remembers::the_last_outcome}) {
    EXPECT_GT(judged(what).count(*invariant_named("memoryless")).violated, 0U) << static_cast<int>(what);
  }
}

TEST(Memoryless, HoldsOfASessionThatKeepsNothing) {
  const SubjectResult result = judged(Remembers::nothing);
  EXPECT_TRUE(result.is_sound()) << result.not_judged;
  EXPECT_GT(result.count(*invariant_named("memoryless")).holds, 10U);
}

/// The solver that turns the sign of zeros in the outcomes of every second call.
Subject turning_zeros(int& turned) {
  return unit::with_answers(
      unit::subject_of("frictionless-double"), [&turned, calls = 0](const auto&, std::vector<Answer>& answers) mutable {
        ++calls;
        for (Answer& answer : answers) {
          if (auto* outcome = std::get_if<ReportedOutcome>(&answer); outcome != nullptr && calls % 2 == 0) {
            static_cast<Outcome<long double>&>(*outcome) = map_outcome<long double>(*outcome, [&](long double x) {
              turned += x == 0 ? 1 : 0;
              return x == 0 ? -x : x;
            });
          }
        }
      });
}

std::uint64_t not_memoryless(const Subject& subject) {
  GateOptions options = unit::gate_options(100, {"immovable_b"});
  options.relations_every = 1000;
  const SubjectResult result = run_gate({subject}, options).results.at(0);
  EXPECT_GT(result.count(*invariant_named("memoryless")).judged(), 10U);
  return result.count(*invariant_named("memoryless")).violated;
}

TEST(Memoryless, TakesEqualNumbersOfAProgramForEqual) {
  int turned = 0;
  Subject program = turning_zeros(turned);
  program.specification = "exec:changing";
  EXPECT_EQ(not_memoryless(program), 0U);
  EXPECT_GT(turned, 0);
}

TEST(Memoryless, TellsTheBitsOfABuiltInApart) {
  int turned = 0;
  EXPECT_GT(not_memoryless(turning_zeros(turned)), 0U);
  EXPECT_GT(turned, 0);
}

TEST(NotJudged, IsASubjectThatSkipsOrShowsNothing) {
  const Subject right = unit::subject_of("frictionless-double");
  const GateOptions options = unit::gate_options(50, {"generic", "separating"});
  const auto result_of = [&](const Subject& subject) { return run_gate({subject}, options).results.at(0); };

  Subject skipping = unit::with_answers(right, [](const auto&, std::vector<Answer>& answers) {
    for (std::size_t i = 0; i < answers.size(); i += 2) {
      answers[i] = Skipped{"every other one"};
    }
  });
  skipping.deviates = {"memoryless"};
  EXPECT_NE(result_of(skipping).not_judged, "");
  EXPECT_FALSE(result_of(skipping).is_sound());

  EXPECT_EQ(result_of(unit::claiming_only("separating_untouched", right)).not_judged,
            "no case exercised an invariant of the outcome of a colliding contact");

  Subject unknown = right;
  unknown.deviates = {"no_such_invariant"};
  unit::expect_in(result_of(unknown).error, {"no_such_invariant"});
}

constexpr int one_in = 100;

/// frictionless-double, as a program. In one of a hundred answers, drawn at random, the impulse is a quarter too large.
Subject faulty() {
  Subject subject = unit::with_outcomes(
      unit::subject_of("frictionless-double"),
      [stream = stream_from(1)](const Collision& collision, ReportedOutcome& outcome) mutable {
        if (stream.chance(one_in)) {
          const auto before = unchanged(collision);
          for (const OutcomeVector k : all_outcome_vectors) {
            *vectors(outcome)[k] += (*vectors(outcome)[k] - vectors(before)[k]->cast<long double>()) / 4;
          }
        }
      });
  subject.specification = "exec:faulty";  // the gate judges relations on fewer cases of a program
  return subject;
}

TEST(RareFault, IsFoundByDefaultByOneRelationInOneFamily) {
  GateOptions options;
  options.families = {family_named("generic")};
  std::size_t relations = 0;
  for (const Invariant& invariant : all_invariants()) {
    // A second impulse is zero, even if the first is too large. So `repeat` cannot find this fault.
    if (std::holds_alternative<AboutRelation>(invariant.about) && invariant.claimed_for(Law::frictionless) &&
        invariant.name != "repeat") {
      ++relations;
      const SubjectResult result = run_gate({unit::claiming_only(invariant.name, faulty())}, options).results.at(0);
      EXPECT_EQ(result.error, "");
      EXPECT_GT(result.count(invariant).violated, 0U) << invariant.name;
    }
  }
  EXPECT_GE(relations, 8U);
}

}  // namespace
}  // namespace carom::properties
