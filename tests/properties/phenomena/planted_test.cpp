// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include <carom/properties/phenomena/measure.hpp>
#include <carom/properties/phenomena/relations.hpp>

#include "planted_engine.hpp"

namespace carom::phenomena_tests {
namespace {

using namespace properties;

Measurement measured(const Defects& defects, std::string_view name, bool planar = false) {
  Stepper engine = planted_engine(defects);
  engine.is_planar = planar;
  Stepper::Session session = engine.open();
  const auto all = all_phenomena();
  const auto phenomenon = std::find_if(all.begin(), all.end(), [&](const Phenomenon& one) { return one.name == name; });
  return measure(*phenomenon, engine, session, quick_ladder());
}

/// The engine without a defect, measured.
const Measurement& right_measurement(std::string_view name) {
  static std::map<std::string_view, Measurement> known;
  const auto found = known.find(name);
  return found != known.end() ? found->second : known.emplace(name, measured({}, name)).first->second;
}

const MeasuredReading& reading_of(const Measurement& measurement, std::string_view what) {
  return *std::find_if(measurement.readings.begin(), measurement.readings.end(),
                       [&](const MeasuredReading& reading) { return reading.what == what; });
}

std::vector<RelationResult> relations(const Defects& defects) {
  const Stepper engine = planted_engine(defects);
  Stepper::Session session = engine.open();
  return heap_relations(engine, session, 1.0 / 60);
}

Likeness likeness(const std::vector<RelationResult>& results, std::string_view name) {
  return std::find_if(results.begin(), results.end(), [&](const auto& one) { return one.name == name; })->likeness;
}

struct Planted {
  Defects defects;
  std::string_view phenomenon;
  std::string_view what;
};

class PlantedDefect : public testing::TestWithParam<Planted> {};

// A defect is told if its median error is more than twice that of the engine without it, at each step.
TEST_P(PlantedDefect, IsToldByItsPhenomenon) {
  const auto& [defects, phenomenon, what] = GetParam();
  const Measurement measurement = measured(defects, phenomenon);
  const MeasuredReading& reading = reading_of(measurement, what);
  const MeasuredReading& right = reading_of(right_measurement(phenomenon), what);
  ASSERT_EQ(reading.rungs.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(reading.rungs[i].median, 2 * right.rungs[i].median + 100 * right.rungs[i].rounding) << phenomenon;
  }
}

const Planted all_planted[] = {
    {{.friction_an_impulse_a_step = true}, "slide-to-roll", "speed at 0.1 s"},
    {{.restitution_threshold = 0.5}, "slow-bounce", "speed after the impact, v = 0.3 m/s"},
    {{.restitution_after_gravity = true}, "bounce", "height of bounce 1, ε = 1"},
    {{.speculation = 1}, "bounce", "height of bounce 1, ε = 0.5"},
    {{.torque = 0}, "spin", "spin about across, gripping"},
    {{.push_out = 0.2}, "flat-landing", "height of the bounce, ε = 0.5, turned by 0°"},
    {{.damping = 0.1}, "slide-to-roll", "speed at 2 s"},
    {{.no_gyroscopic_term = true}, "free-rotation", "change of the angular momentum at 10 s, about the middle axis"},
    {{.explicit_gyroscopic_term = true},
     "free-rotation",
     "change of the angular momentum at 10 s, about the short axis"},
    {{.contacts_a_step_late = true}, "bounce", "height of bounce 1, ε = 0"},
    {{.binary32_state = true}, "slow-bounce", "speed after the impact, v = 0.03 m/s"},
    {{.friction_axes = {1, 0, 0}}, "spin", "velocity across, slipping, diagonal"},
    {{.friction_beyond_the_cone = true}, "spin", "velocity right, slipping"},
    {{.corners = 1}, "flat-landing", "turn, ε = 0, turned by 30°"}};

INSTANTIATE_TEST_SUITE_P(All, PlantedDefect, testing::ValuesIn(all_planted));

TEST(PlantedEngine, HasTwoDefectsThatRelationsTell) {
  EXPECT_NE(likeness(relations({.insertion_order = true}), "swap"), Likeness::same_bits);
  EXPECT_NE(likeness(relations({.surviving_warm_starts = true}), "memoryless"), Likeness::same_bits);
}

TEST(PlantedEngine, KeepsTheRelationsThatItsDesignKeeps) {
  const std::vector<RelationResult> results = relations(Defects{});
  for (const char* name : {"memoryless", "swap", "local"}) {
    EXPECT_EQ(likeness(results, name), Likeness::same_bits) << name;
  }
  // A sum of 8 m rounds the places, and the order of the contacts follows the axes.
  EXPECT_NE(likeness(results, "translation"), Likeness::unanswered);
  EXPECT_NE(likeness(results, "translation"), Likeness::same_bits);
  EXPECT_EQ(results.size(), 7U);
}

// The engine finds an impact at the end of a step, so it is off by up to a step's worth at each impact. If nothing
// explains an error, the contacts converge to 10⁻⁹ a step.
void expect_step_worth(const Measurement& measurement) {
  EXPECT_TRUE(measurement.unanswered.empty());
  EXPECT_FALSE(measurement.readings.empty());
  for (const MeasuredReading& reading : measurement.readings) {
    for (const Rung& rung : reading.rungs) {
      if (rung.greatest_in_worths > 0) {
        EXPECT_LT(rung.greatest_in_worths, 2) << reading.what;
      } else {
        EXPECT_LT(rung.greatest, 1e-10) << reading.what;
      }
    }
  }
}

TEST(PlantedEngine, IsOffByAStepWorth) {
  for (const char* name : {"bounce", "slow-bounce", "slide", "slide-to-roll", "stick", "spin", "flat-landing"}) {
    SCOPED_TRACE(name);
    expect_step_worth(right_measurement(name));
    expect_step_worth(measured({}, name, true));
  }
}

TEST(PlantedEngine, HasNoExcuseWithoutGravity) {
  for (const char* name : {"slow-bounce", "spin"}) {
    double greatest = 0;
    for (const MeasuredReading& reading : measured({.torque = 0, .binary32_state = true}, name).readings) {
      for (const Rung& rung : reading.rungs) {
        greatest = std::max(greatest, rung.greatest);
        EXPECT_EQ(rung.greatest_in_worths, 0) << reading.what;
      }
    }
    EXPECT_GT(greatest, 0) << name;
  }
}

TEST(PlantedEngine, ConvergesWithTheFirstOrder) {
  const Stepper engine = planted_engine({});
  Stepper::Session session = engine.open();
  const Ladder ladder{{1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480}, 8};
  const Measurement measurement = measure(all_phenomena()[0], engine, session, ladder);
  const auto order = reading_of(measurement, "height of bounce 1, ε = 0.5").order;
  ASSERT_TRUE(order.has_value());
  EXPECT_NEAR(*order, 1, 0.15);
}

TEST(PlantedEngine, ConservesTheAngularMomentumOfABrick) {
  for (const MeasuredReading& reading : right_measurement("free-rotation").readings) {
    for (const Rung& rung : reading.rungs) {
      if (reading.what.find("momentum") != std::string::npos) {
        EXPECT_LT(rung.greatest, 1e-11) << reading.what;
      } else if (reading.what.find("at 1 s") != std::string::npos) {
        EXPECT_LT(rung.greatest_in_worths, 1) << reading.what;
      }
    }
  }
}

// Without continuous detection, a sphere passes a wall of half its diameter as soon as a step is longer than both.
TEST(PlantedEngine, LetsFastSpheresPass) {
  const Measurement& measurement = right_measurement("pass-through");
  EXPECT_EQ(reading_of(measurement, "passes, wall, 0.25 diameters a step").rungs[0].greatest, 0);
  EXPECT_EQ(reading_of(measurement, "passes, wall, 4 diameters a step").rungs[0].greatest, 1);
  ASSERT_EQ(measurement.unanswered.size(), 1U);
  EXPECT_EQ(measurement.unanswered[0].why, "the subject cannot pose: continuous");
  EXPECT_EQ(measurement.unanswered[0].steps.size(), measurement.runs / 2);
}

}  // namespace
}  // namespace carom::phenomena_tests
