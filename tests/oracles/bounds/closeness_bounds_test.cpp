// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>

#include <carom/oracles/filters/closeness_bounds.hpp>
#include <carom/oracles/filters/slopes.hpp>
#include <carom/oracles/judge/compare.hpp>

#include "covers.hpp"
#include "normalised_collision.hpp"

/// Checks the constants of oracles/filters/closeness_bounds.hpp by its inequalities (3) to (6). That header defines the
/// symbols. closeness_test.cpp checks (1).
namespace carom::bounds {
namespace {

namespace closeness = oracles::closeness_bounds;
using SlopeDual = oracles::Dual<RoundingCount, oracles::outcome_inputs>;

/// For each k, the norm of the rounding errors of ∂g/∂ŷ_k, in units of u. The roundings of the norm itself do not
/// count. Velocities are at most one.
template <class OneEquation>
PerVector<double> errors_of_slopes(const OneEquation& equation, bool against_wall = false) {
  BasicCollision<SlopeDual> c = normalised_collision<SlopeDual>();
  c.b.immovable = against_wall;
  Outcome<SlopeDual> outcome;
  std::size_t next = 0;
  for (Vector3<SlopeDual>* part : vectors(outcome)) {
    for (int i = 0; i < 3; ++i) {
      (*part)[i] = SlopeDual::input(RoundingCount::input(0.5), next++);
    }
  }
  const auto sides = equation(c, outcome);
  PerVector<double> errors{};
  std::size_t first = 0;
  for (const OutcomeVector k : all_outcome_vectors) {
    double squares = 0;
    for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
      for (std::size_t j = first; j < first + 3; ++j) {
        const double error = (sides.left[i].derivative[j] - sides.right[i].derivative[j]).error();
        squares += error * error;
      }
    }
    errors[k] = std::sqrt(squares);
    first += 3;
  }
  return errors;
}

/// The roundings of a norm of up to six components: the squares, their sum and the root.
constexpr double roundings_of_norm = 6;

/// Inequality (3). Here max I, m, ‖r‖ and ‖N‖ are one. The slopes are ‖J‖ ≥ max I, ‖m [r]‖ ≥ m ‖r‖ and ‖N × (· × r)‖ ≥
/// ‖N‖ ‖r‖, so they are at least one. So the relative error of a slope is at most its absolute error.
TEST(ClosenessBounds, CoverTheRoundingOfSlopes) {
  namespace equation = oracles::equation;
  double most = 0;
  const auto note = [&](const PerVector<double>& errors) {
    most = std::max(most, *std::max_element(errors.begin(), errors.end()) + roundings_of_norm);
  };
  note(errors_of_slopes(equation::Untouched{OutcomeVector::velocity_of_a}));
  note(errors_of_slopes(equation::AngularMomentum{true}));
  note(errors_of_slopes(equation::AngularMomentum{false}));
  note(errors_of_slopes(equation::TotalAngularMomentum{}));
  note(errors_of_slopes(equation::LinearMomentum{}));
  note(errors_of_slopes(equation::Push{true}));
  note(errors_of_slopes(equation::FrictionlessDirection{true}));
  note(errors_of_slopes(equation::ReflectionPlane{}));
  EXPECT_TRUE(covers(closeness::rounding_of_slope, most * u, 4));
}

/// Inequality (4). The errors are relative to t_k. Here t_k = 1, as a product of ones.
TEST(ClosenessBounds, CoverTheNoiseOfSlopesThatCancel) {
  const PerVector<double> of_moment = errors_of_slopes(oracles::equation::Restitution{});
  EXPECT_TRUE(covers(
      closeness::noise_of_moment,
      (std::max(of_moment[OutcomeVector::angular_velocity_of_a], of_moment[OutcomeVector::angular_velocity_of_b]) +
       roundings_of_norm) *
          u,
      16));
  for (const bool against_wall : {false, true}) {
    const PerVector<double> of_energy = errors_of_slopes(oracles::equation::Energy{}, against_wall);
    const double most = *std::max_element(of_energy.begin(), of_energy.end()) + roundings_of_norm;
    EXPECT_TRUE(covers(closeness::noise_of_energy_slope, most * u, 4));
  }
}

/// Inequality (5). h covers the rounding and the noise of slopes, and the roundings of sums and products.
TEST(ClosenessBounds, SetAsideMoreThanIsLost) {
  constexpr double of_noise = closeness::share_for_noise * (1 + 4 * closeness::share_for_noise);
  constexpr double of_sums = 32 * u;
  EXPECT_LE((1 - closeness::set_aside) * (1 + closeness::rounding_of_slope + of_noise) * (1 + of_sums), 1);
  EXPECT_TRUE(covers(closeness::set_aside, closeness::rounding_of_slope + of_noise + of_sums, 4));
}

/// Inequality (6).
TEST(ClosenessBounds, LeaveAScaleThatTheJudgeTakes) {
  EXPECT_EQ(oracles::least_slope_of_moderate * closeness::least_size, oracles::smallest_scale);
  EXPECT_TRUE(
      covers(closeness::least_scale_of_energy, oracles::smallest_scale / (1 - 2 * closeness::share_for_noise), 2));
  EXPECT_LE(oracles::largest_scale_of_moderate, oracles::largest_scale);
}

}  // namespace
}  // namespace carom::bounds
