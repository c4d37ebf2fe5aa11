// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <stop_token>

#include <gtest/gtest.h>

#include <carom/properties/phenomena/claims.hpp>
#include <carom/properties/phenomena/measure.hpp>
#include <carom/properties/phenomena/phenomena.hpp>
#include <carom/properties/phenomena/relations.hpp>

#include "support/message_of.hpp"

namespace carom::phenomena_tests {
namespace {

using namespace properties;

SteppedStates unmoved(const Stepping& stepping) {
  std::vector<BodyState> states;
  for (const SteppedBody& body : stepping.scene.bodies) {
    states.push_back(body.state);
  }
  return {std::vector(stepping.report.size(), states), 1e-6 * static_cast<double>(steps_of(stepping))};
}

/// An engine in which nothing moves, with changed states.
template <class Change>
Stepper::Session unmoving(Change change) {
  return [=](const Stepping& stepping) mutable -> SteppingAnswer {
    SteppedStates states = unmoved(stepping);
    change(states.states);
    return states;
  };
}

const Stepper::Session unchanged = unmoving([](auto&) {});

Measurement measured(Stepper::Session session, const Phenomenon& phenomenon = slow_bounce(),
                     std::vector<std::string> cannot = {}) {
  Stepper stepper{"test"};
  stepper.cannot = std::move(cannot);
  return measure(phenomenon, stepper, session, quick_ladder());
}

std::vector<RelationResult> relations(Stepper::Session session, const Stepper& stepper = {"test"}) {
  return heap_relations(stepper, session, 1.0 / 60);
}

TEST(Phenomena, HaveReadingsWithSmallBounds) {
  for (const bool planar : {false, true}) {
    for (const Phenomenon& phenomenon : all_phenomena()) {
      EXPECT_FALSE(std::string(phenomenon.yardstick).empty()) << phenomenon.name;
      for (const PosedRun& run : phenomenon.runs(quick_ladder(), planar)) {
        for (const Reading& reading : run.read(unmoved(run.stepping))) {
          EXPECT_GT(reading.scale, 0) << reading.what;
          EXPECT_LT(reading.bound, 1e-12 * reading.scale) << reading.what;
        }
        for (const SteppedBody& body : run.stepping.scene.bodies) {
          EXPECT_TRUE(!planar || (body.state.position[2] == 0 && body.state.velocity[2] == 0)) << phenomenon.name;
        }
      }
    }
  }
}

TEST(Measure, CountsWhatHasNoAnswer) {
  const auto skips = [](const Stepping&) -> SteppingAnswer { return Skipped{"not today"}; };
  const Measurement skipped = measured(skips);
  ASSERT_EQ(skipped.unanswered.size(), 1U);
  EXPECT_EQ(skipped.unanswered[0].why, "not today");
  EXPECT_EQ(skipped.unanswered[0].steps.size(), skipped.runs);
  EXPECT_TRUE(skipped.readings.empty());
  const Measurement cannot = measured(skips, slow_bounce(), {"friction", "half_space"});
  EXPECT_EQ(cannot.unanswered[0].why, "the subject cannot pose: half_space");
}

TEST(Measure, GivesUpAfterThreeFailures) {
  const Measurement failed = measured(
      unmoving([](auto& states) { states.back().back().velocity[1] = std::numeric_limits<double>::quiet_NaN(); }));
  ASSERT_EQ(failed.unanswered.size(), 2U);
  EXPECT_EQ(failed.unanswered[0].why, "a state has an infinity or NaN");
  EXPECT_TRUE(failed.unanswered[0].is_failure);
  EXPECT_EQ(failed.unanswered[0].steps.size(), 3U);
  EXPECT_EQ(failed.unanswered[1].why, "the subject failed three times before");
  const Measurement incomplete = measured(unmoving([](auto& states) { states.back().pop_back(); }));
  EXPECT_EQ(incomplete.unanswered[0].why, "the answer has not a state for each body at each time");
}

// The square of the speed overflows, so the height of the bounce is no number.
TEST(Measure, TakesAReadingThatIsNoNumberForAFailure) {
  const Measurement fast = measured(unmoving([](auto& states) { states[0][1].velocity[2] = 1e200; }), bounce());
  ASSERT_FALSE(fast.unanswered.empty());
  EXPECT_TRUE(fast.unanswered[0].is_failure);
  EXPECT_EQ(fast.unanswered[0].why, "no number can be read off the states: height of bounce 1, ε = 0");
  for (const MeasuredReading& reading : fast.readings) {
    EXPECT_LT(reading.rungs[0].greatest, 1e300) << reading.what;
  }
}

TEST(Measure, AsksNoMoreAfterAStopOrThreeMinutesOfFailures) {
  unsigned asked = 0;
  const Stepper::Session hung = [&](const Stepping&) -> SteppingAnswer {
    ++asked;
    return Failed{"hung"};
  };
  const Stepping any{{}, 1.0 / 60, {1}};
  std::string told;
  const auto tell = [&](const std::string& why) { told += why; };
  EXPECT_EQ(std::get<Failed>(patient(hung, {}, tell, 179)(any)).why, "hung");
  EXPECT_EQ(told, "hung");
  EXPECT_EQ(std::get<Skipped>(patient(hung, {}, tell, 181)(any)).why, "runs that failed took three minutes before");
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(std::get<Skipped>(patient(hung, source.get_token(), tell)(any)).why, "the measurement was interrupted");
  EXPECT_EQ(asked, 1U);
}

// The wall stands from 0 to 0.1 m.
TEST(PassThrough, IsBeyondTheFarFaceOfTheWall) {
  for (const bool is_beyond : {false, true}) {
    const Measurement measurement =
        measured(unmoving([=](auto& states) { states[0][1].position[0] = is_beyond ? 0.15 : 0.05; }), pass_through());
    const auto wall = std::find_if(measurement.readings.begin(), measurement.readings.end(),
                                   [](const auto& one) { return one.what == "passes, wall, 1 diameters a step"; });
    ASSERT_NE(wall, measurement.readings.end());
    EXPECT_EQ(wall->rungs[0].median, is_beyond ? 1 : 0);
  }
}

// The first of seven readings is off by 3 − 1.4 k in phase k of 6.
TEST(Measure, GathersErrorsAndTimes) {
  const Measurement rising =
      measured(unmoving([calls = 0](auto& states) mutable { states[0][1].velocity[2] += 0.001 * calls++; }));
  ASSERT_EQ(rising.readings.size(), 7U);
  const Rung& rung = rising.readings[0].rungs[0];
  EXPECT_EQ(rung.answers, 6U);
  EXPECT_NEAR(rung.least, 0.2, 1e-12);
  EXPECT_NEAR(rung.median, 2.1, 1e-12);
  EXPECT_NEAR(rung.greatest, 4, 1e-12);
  EXPECT_NEAR(rung.shift, 0.5, 1e-12);
  EXPECT_EQ(rung.expected, 1);
  ASSERT_EQ(rising.step_times.size(), 2U);
  EXPECT_NEAR(rising.step_times[1].seconds, 1e-6, 1e-12);
}

TEST(Measure, SeesADriftACreepAndATurn) {
  const Stepper::Session moved = unmoving([](auto& states) {
    states.back()[1].position[0] += 0.25;
    states.back()[1].orientation = {0, 0, 0, 1};
  });
  for (const Phenomenon& phenomenon : {stack(), flat_landing(), stick(), slide()}) {
    for (const MeasuredReading& reading : measured(moved, phenomenon).readings) {
      if (reading.what.starts_with("drift") || reading.what.starts_with("turn") || reading.what.find("creep") < 99) {
        EXPECT_GT(reading.rungs[0].least, 0.1) << reading.what;
      }
    }
  }
}

TEST(Stack, StandsIfNothingMovesAndNotIfTheHighestCubeSinks) {
  for (const MeasuredReading& reading : measured(unchanged, stack()).readings) {
    EXPECT_EQ(reading.rungs[0].greatest, 0) << reading.what;
  }
  const Measurement sunk = measured(unmoving([](auto& states) { states.back().back().position[2] -= 0.25; }), stack());
  for (const MeasuredReading& reading : sunk.readings) {
    EXPECT_EQ(reading.rungs[0].shift, reading.what.starts_with("rise of the highest cube") ? -0.25 : 0) << reading.what;
  }
}

TEST(Measure, FitsTheOrder) {
  std::vector<Rung> rungs(4);
  for (std::size_t i = 0; i < 4; ++i) {
    rungs[i].step = std::pow(0.5, static_cast<double>(i));
    rungs[i].median = 3 * rungs[i].step * rungs[i].step;
  }
  EXPECT_NEAR(fitted_order(rungs).value(), 2, 1e-12);
  rungs[3].rounding = 1;
  rungs[3].median = 1;  // rounding, which would spoil the slope
  EXPECT_NEAR(fitted_order(rungs).value(), 2, 1e-12);
  rungs[2].rounding = 1;
  EXPECT_EQ(fitted_order(rungs), std::nullopt);
}

TEST(TimeClaims, AreRead) {
  const TimeClaim claim = time_claim_from("pass-through within 0.5% at 1/240 s");
  EXPECT_EQ(claim.phenomenon, "pass-through");
  EXPECT_NEAR(claim.within, 0.005, 1e-15);
  EXPECT_NEAR(claim.step, 1.0 / 240, 1e-15);
}

TEST(TimeClaims, HaveStepsThatThePhenomenaCanTake) {
  EXPECT_EQ(step_from("1/60"), 1.0 / 60);
  EXPECT_EQ(step_from("0.01"), 0.01);
  for (const char* text : {"", "0.5", "1e-300", "1e-6", "1/0", "1/", "-1/60", " 1/60", "1/ 60", "0x1p-6", "nan"}) {
    EXPECT_EQ(step_from(text), std::nullopt) << text;
  }
}

TEST(TimeClaims, ThatAreNoneAreRefused) {
  for (const char* text :
       {"", "bounce", "bounce within 5 at 1/60 s", "bounce within 5% at 1/0 s", "bounce within -5% at 1 s",
        "bounce within 5% at 1/60 ms", "bounce within 5%% at 1 s", "bounce within 5% at 1/60/2 s"}) {
    EXPECT_THROW((void)time_claim_from(text), std::invalid_argument) << text;
  }
  EXPECT_EQ(unit::message_of<std::invalid_argument>([] { return time_claim_from("bonce within 5% at 1/60 s"); }),
            "the claim 'bonce within 5% at 1/60 s' names no phenomenon; did you mean 'bounce'?");
}

TEST(TimeClaims, NeedAnAnswerAtTheirStep) {
  const TimeClaim claim{"slow-bounce", 10, 1.0 / 60};
  const Measurement unmoving = measured(unchanged);
  EXPECT_TRUE(verdict_of(claim, unmoving).is_kept);
  EXPECT_FALSE(verdict_of({"slow-bounce", 2.9, 1.0 / 60}, unmoving).is_kept);
  EXPECT_EQ(verdict_of({"slow-bounce", 10, 1.0 / 61}, unmoving).why, "the step was not measured");
  EXPECT_FALSE(verdict_of({"slow-bounce", 10, 1.0 / 61}, unmoving).is_kept);
  const Measurement skipped = measured([](const Stepping&) -> SteppingAnswer { return Skipped{"not today"}; });
  EXPECT_EQ(verdict_of(claim, skipped).why, "a run has no answer: not today");
}

// An engine that moves the first body to x feels the changes of order and direction.
TEST(Relations, MapTheStatesBack) {
  for (const bool planar : {false, true}) {
    Stepper stepper{"test"};
    stepper.is_planar = planar;
    const std::vector<RelationResult> results = relations(unchanged, stepper);
    EXPECT_EQ(results.size(), planar ? 6U : 7U);
    for (const RelationResult& result : results) {
      EXPECT_EQ(result.likeness, result.name == "energy" ? Likeness::same_digits : Likeness::same_bits) << result.name;
    }
  }
  for (const RelationResult& result : relations(unmoving([](auto& all) { all.back()[1].position[0] += 0.25; }))) {
    const bool feels = result.name == "swap" || result.name == "reflection_symmetry" || result.name == "rotation";
    if (result.name != "energy") {
      EXPECT_EQ(result.likeness, feels ? Likeness::differs : Likeness::same_bits) << result.name;
      EXPECT_EQ(in_words(result), feels ? "differs from 2 s on" : "same bits") << result.name;
    }
  }
}

TEST(Relations, TellARowOfBallsThatGainsEnergy) {
  const RelationResult result = relations(unmoving([](auto& states) { states.back().back().velocity[1] += 3; })).back();
  EXPECT_EQ(result.likeness, Likeness::differs);
  EXPECT_EQ(in_words(result), "10 times the energy");
}

// The places differ by 2 and by 4 µm.
TEST(Relations, CountTheDigitsThatAreTheSame) {
  const auto results =
      relations(unmoving([calls = 0](auto& all) mutable { all.back()[1].position[2] += 2e-6 * ++calls; }));
  EXPECT_EQ(in_words(results[0]), "same to 5 digits until 2 s");
}

}  // namespace
}  // namespace carom::phenomena_tests
