// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <carom/oracles/exact/rational.hpp>
#include <carom/properties/draws/stream.hpp>
#include <carom/scene/polyhedra/orientation.hpp>

namespace carom::scene {
namespace {

using oracles::Rational;

/// The sign of ((b − a) × (c − a)) · (d − a) in ℚ.
int exact_sign(const std::array<Vector3<double>, 4>& points) {
  const auto side = [&](std::size_t i) {
    Vector3<Rational> result;
    for (int axis = 0; axis < 3; ++axis) {
      result[axis] = Rational(points[i][axis]) - Rational(points[0][axis]);
    }
    return result;
  };
  return oracles::sign_of(side(1).cross(side(2)).dot(side(3)));
}

/// 2³⁰⁰ · 2⁻⁵⁴⁰ · 2⁻⁵⁴⁰ − 2⁻²⁶⁰ · 2⁻⁵⁴⁰ is positive. In binary64 the first product underflows.
TEST(Orientation, IsExactIfAProductUnderflows) {
  EXPECT_EQ(orientation({0, 0, 0}, {0x1p-260, 0x1p-540, 0}, {0, 0, 0x1p-540}, {0x1p+300, 1, 0}), 1);
}

/// Numbers of like and of very unlike sizes; often the four points nearly lie in a plane.
TEST(Orientation, IsExactForNumbersOfAnySize) {
  properties::Stream stream = properties::stream_from(17);
  int decided = 0;
  for (int i = 0; i < 20000; ++i) {
    const int spread = stream.chance(2) ? 3 : 400;
    std::array<Vector3<double>, 4> p;
    for (Vector3<double>& point : p) {
      for (double& number : point) {
        number = stream.chance(4) ? 0 : std::ldexp(stream.integer(-3, 3), stream.integer(-spread, spread));
      }
    }
    const int expected = exact_sign(p);
    decided += expected != 0 ? 1 : 0;
    ASSERT_EQ(orientation(p[0], p[1], p[2], p[3]), expected) << i;
  }
  EXPECT_GT(decided, 5000);
}

}  // namespace
}  // namespace carom::scene
