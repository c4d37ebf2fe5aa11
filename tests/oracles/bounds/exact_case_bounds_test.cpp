// SPDX-License-Identifier: BSL-1.0
#include "exact_case_bounds_test.cpp"

#include <cmath>

#include <carom/collision/outcome.hpp>
#include <carom/oracles/bounds/dual.hpp>
#include <carom/oracles/judge/exact_case_bounds.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/truths/superposition.hpp>

#include "covers.hpp"
#include "support/exact.hpp"
#include "support/rounding_count.hpp"

/// Checks the inequalities and constants of oracles/judge/exact_case_bounds.hpp. That header defines the symbols.
namespace carom::bounds {

/// The bodies are at the origin, so the lever arm r = P − X is P. P counts as rounded once, like the difference P − X.
template <class T>
[[nodiscard]] BasicCollision<T> normalised_collision() {
  BasicCollision<T> c;
  const T input(RoundingCount::input());
  for (BasicBody<T>* body : {&c.a, &c.b}) {
    body->mass = input;
    body->principal_inertia.setConstant(input);
    body->orientation.setConstant(input);
    body->velocity.setConstant(T(RoundingCount::input(0.5)));
    body->angular_velocity.setConstant(T(RoundingCount::input(0.5)));
  }
  c.point.setConstant(T(RoundingCount::input(1, 1)));
  c.normal.setConstant(input);
  c.restitution = input;
  return c;
}

namespace {

namespace exact_case_bounds = oracles::exact_case_bounds;

TEST(ExactCase, KnowANormalVelocityToSixDigits) {
  EXPECT_TRUE(covers(1e-6, exact_case_bounds::known_radius_of_normal_velocity + u, 1.1));
}

template <class S, class Convert>
BasicCollision<oracles::Dual<S, 8>> with_inertia_as_inputs(BasicCollision<oracles::Dual<S, 8>> c,
                                                           const Convert& convert) {
  std::size_t next = 0;
  for (BasicBody<oracles::Dual<S, 8>>* body : {&c.a, &c.b}) {
    body->mass = oracles::Dual<S, 8>::input(convert(body->mass), next++);
    for (int i = 0; i < 3; ++i) {
      body->principal_inertia[i] = oracles::Dual<S, 8>::input(convert(body->principal_inertia[i]), next++);
    }
  }
  return c;
}

/// Inequality (1) for K follows from Σ_j x_j ∂K/∂x_j = −K over the masses and moments x_j. This test checks the
/// equation exactly.
TEST(ExactCase, RestOnAMatrixThatIsHomogeneous) {
  using T = oracles::Dual<oracles::Rational, 8>;
  properties::Stream stream = properties::stream_from(71);
  for (int i = 0; i < 50; ++i) {
    Collision c = unit::small_collision(stream);
    c.b.immovable = false;
    const auto lifted = map_numbers<T>(c, [](double x) { return T(oracles::Rational(x)); });
    const auto k =
        oracles::response_matrix(with_inertia_as_inputs<oracles::Rational>(lifted, [](const T& x) { return x.value; }));
    for (const T& entry : k.reshaped()) {
      oracles::Rational sum(0);
      std::size_t next = 0;
      for (const Body* body : {&c.a, &c.b}) {
        sum += oracles::Rational(body->mass) * entry.derivative[next++];
        for (int axis = 0; axis < 3; ++axis) {
          sum += oracles::Rational(body->principal_inertia[axis]) * entry.derivative[next++];
        }
      }
      EXPECT_EQ(sum, -entry.value) << i;
    }
  }
}

/// The error of Σ_j ‖∂K/∂x_j‖_F |x_j| over masses and moments x_j, in units of u, for ‖r‖ = 1 and min I = 1.
double error_of_matrix_sensitivity() {
  using T = oracles::Dual<RoundingCount, 8>;
  const Matrix3<T> k = oracles::response_matrix(
      with_inertia_as_inputs<RoundingCount>(normalised_collision<T>(), [](const T& x) { return x.value; }));
  double sum = 0;
  for (std::size_t j = 0; j < 8; ++j) {
    double squares = 0;
    for (const T& entry : k.reshaped()) {
      squares += entry.derivative[j].error() * entry.derivative[j].error();
    }
    sum += std::sqrt(squares);
  }
  return sum;
}

/// Inequalities (2) and (3) for K.
TEST(ExactCase, CoverTheRoundingOfTheMatrixSensitivity) {
  const double needed = error_of_matrix_sensitivity();
  EXPECT_TRUE(covers(exact_case_bounds::roundings_of_matrix_sensitivity, needed, 4));
  EXPECT_LE(exact_case_bounds::roundings_of_matrix_sensitivity * u / exact_case_bounds::least_share_of_largest_terms,
            0.25);
}

}  // namespace

}  // namespace carom::bounds
