// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/rotation.hpp>
#include <carom/oracles/bounds/dual.hpp>
#include <carom/oracles/exact/radical.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/truths/superposition.hpp>
#include <carom/properties/draws/stream.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;
using RationalDual = Dual<Rational, 2>;

static_assert(Fraction<Rational> && Fraction<Radical> && Fraction<RationalDual> && Fraction<Dual<Radical, 2>>);
static_assert(!Fraction<double> && !Fraction<long double> && !Fraction<Enclosure> && !Fraction<Dual<double, 2>>);

template <class T>
Rational denominator_of(const std::vector<T>& numbers) {
  return Rational(common_denominator(std::span<const T>(numbers)));
}

TEST(CommonDenominator, IsTheLeastThatLeavesIntegers) {
  EXPECT_EQ(denominator_of<Rational>({}), 1);
  EXPECT_EQ(denominator_of<Rational>({Rational(0), Rational(-5)}), 1);
  EXPECT_EQ(denominator_of<Rational>({ratio(-1, 6), ratio(3, 4), Rational(5)}), 12);
  const Radical root = Radical::root_of(Rational(2));
  EXPECT_EQ(denominator_of<Radical>({Radical(ratio(1, 2)) + Radical(ratio(1, 3)) * root, Radical(ratio(1, 4))}), 12);
  RationalDual dual(ratio(1, 5));
  dual.derivative = {Rational(2), ratio(-3, 7)};
  EXPECT_EQ(denominator_of<RationalDual>({dual, RationalDual(ratio(1, 3))}), 105);
}

/// Fractions with denominators from 1 to 12.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : stream_(properties::stream_from(seed)) {}

  Rational rational() {
    return ratio(static_cast<int>(stream_.below(41)) - 20, static_cast<int>(stream_.below(12)) + 1);
  }
  Radical radical() { return Radical(rational()) + Radical(rational()) * Radical::root_of(Rational(3)); }
  RationalDual dual() {
    RationalDual result(rational());
    result.derivative = {rational(), rational()};
    return result;
  }

 private:
  properties::Stream stream_;
};

/// Numbers that are all 0 only if x is.
std::array<Rational, 1> parts(const Rational& x) { return {x}; }
std::array<Rational, 2> parts(const Radical& x) { return {x.rational_part(), x.coefficient()}; }
std::array<Rational, 3> parts(const RationalDual& x) { return {x.value, x.derivative[0], x.derivative[1]}; }

template <class T, int Rows, int Columns>
void expect_equal(const Eigen::Matrix<T, Rows, Columns>& x, const Eigen::Matrix<T, Rows, Columns>& y) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    for (const Rational& part : parts(T(x(i) - y(i)))) {
      EXPECT_EQ(part, 0);
    }
  }
}

/// With the common denominator taken out, rotations, Cramer's rule and maps give what they give without it.
template <class T, class Draw>
void expect_linear_maps_are_exact(const Draw& draw) {
  for (int i = 0; i < 20; ++i) {
    const auto vector = [&] { return Vector3<T>{draw(), draw(), draw()}; };
    Matrix3<T> matrix;
    matrix << vector(), vector(), vector();
    const Vector3<T> v = vector();
    expect_equal<T, 3, 1>(mapped_linearly(v, [&](const Vector3<T>& x) { return Vector3<T>(matrix * x); }), matrix * v);
    Quaternion<T> q{draw(), draw(), draw(), draw()};
    q[0] = q[0] * q[0] + T(1);  // not zero
    expect_equal<T, 3, 1>(turned<T>(q, v), impulse::rotation_matrix<T>(q) * v);
    const Matrix3<T> definite = matrix * matrix.transpose() + Matrix3<T>::Identity();
    expect_equal<T, 3, 1>(definite * cramer<T>(definite, v), v);
  }
}

TEST(LinearMaps, OfFractionsAreExact) {
  Draws draws(31);
  expect_linear_maps_are_exact<Rational>([&] { return draws.rational(); });
  expect_linear_maps_are_exact<Radical>([&] { return draws.radical(); });
  expect_linear_maps_are_exact<RationalDual>([&] { return draws.dual(); });
}

}  // namespace
}  // namespace carom::oracles
