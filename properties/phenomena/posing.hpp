// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <carom/oracles/motion/known.hpp>
#include <carom/properties/phenomena/phenomenon.hpp>

/// Directions, bodies, times and readings that the phenomena share.
namespace carom::properties::posing {

inline constexpr double gravity = 9.81;  // [m/s²]

/// The directions of a set-up. Up is z, or y in the plane z = 0.
struct Directions {
  bool is_planar = false;
  Vector3<double> right{1, 0, 0};
  Vector3<double> up{0, 0, 1};
  Vector3<double> across{0, 1, 0};  // up × right: a sphere that rolls to the right turns about it

  [[nodiscard]] Vector3<double> at(double to_the_right, double upwards) const;
};

[[nodiscard]] Directions directions(bool planar);

/// A half-space below the origin.
[[nodiscard]] SteppedBody floor(const Directions& d);

/// A solid sphere, or a disc in the plane, of 1 kg.
[[nodiscard]] SteppedBody ball(const Directions& d, double radius);

/// J of `ball` about the axis across [kg m²].
[[nodiscard]] double rolling_inertia(const Directions& d, const SteppedBody& ball);

/// A uniform box with the lengths `along` (to the right), `across` and `high`.
[[nodiscard]] SteppedBody block(const Directions& d, double along, double across, double high, double mass);

/// A scene with a floor, which is body 0, and gravity.
[[nodiscard]] SteppedScene on_the_floor(const Directions& d);

/// The number of whole steps nearest to a time, at least 1.
[[nodiscard]] std::uint64_t steps_to(double time, double step);

/// The steps nearest to some times, ascending and each once.
[[nodiscard]] std::vector<std::uint64_t> report_at(const std::vector<double>& times, double step);

/// The states that were reported nearest to a time.
struct Reported {
  oracles::StepTime time;
  const std::vector<BodyState>& bodies;

  [[nodiscard]] double seconds() const { return time.step * static_cast<double>(time.steps); }
};
[[nodiscard]] Reported reported_at(const SteppedStates& states, const std::vector<std::uint64_t>& report, double time,
                                   double step);

/// Calls pose(runs, directions, step, share of a step) for each step and each phase. Returns the runs that it adds.
template <class Pose>
[[nodiscard]] std::vector<PosedRun> at_each_phase(const Ladder& ladder, bool planar, Pose pose) {
  std::vector<PosedRun> runs;
  for (const double step : ladder.steps) {
    for (unsigned phase = 0; phase < ladder.phases; ++phase) {
      pose(runs, directions(planar), step, static_cast<double>(phase) / static_cast<double>(ladder.phases));
    }
  }
  return runs;
}

/// A height near `height`. A fall from it takes a whole number of steps and the share of one.
[[nodiscard]] double height_of_fall(double height, double step, double share);

/// A bound of the rounding of a formula that reads a number of this size off states in binary64: 8 roundings.
[[nodiscard]] double rounding_of(double size);

/// A reading, with the bound of its answer and of the formula that reads it off numbers of this size.
[[nodiscard]] Reading reading(std::string what, std::string unit, double measured, const oracles::Known& right,
                              double scale, double step_worth, double size);

/// The angle of the rotation between two attitudes [rad].
[[nodiscard]] double turn_between(const Quaternion<double>& from, const Quaternion<double>& to);

/// "0.5", "30": as short as possible.
[[nodiscard]] std::string number(double x);

}  // namespace carom::properties::posing
