// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/refined.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/world_inertia.hpp>
#include <carom/oracles/exact/rational.hpp>

#include "support/cases.hpp"
#include "support/exact.hpp"

/// Bodies at the border of slenderness keep their accuracy by plain cross products. Contacts that turn no body take the
/// frictionless law.
namespace carom::impulse {
namespace {

using unit::Rational;

template <class S>
class NotSlender : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(NotSlender, Scalars);

Vector3<Rational> lifted(const auto& vector) { return {Rational(vector[0]), Rational(vector[1]), Rational(vector[2])}; }

/// max |x_i − y_i|.
template <class S>
double greatest_difference(const Vector3<S>& x, const Vector3<Rational>& y) {
  double greatest = 0;
  for (int i = 0; i < 3; ++i) {
    greatest = std::max(greatest, std::abs(oracles::to_double(Rational(Rational(x[i]) - y[i]))));
  }
  return greatest;
}

/// Moments 1 : x : 8 in any order. The ratio is at the border: the body is not slender.
template <class S>
Vector3<S> moments_at_the_border(properties::Stream& stream) {
  std::array<S, 3> moments{S(1), static_cast<S>(1 + 7 * stream.unit()), S(least_ratio_of_slender_moments)};
  std::swap(moments[0], moments[static_cast<std::size_t>(stream.integer(0, 2))]);
  std::swap(moments[1], moments[static_cast<std::size_t>(stream.integer(1, 2))]);
  return {moments[0], moments[1], moments[2]};
}

/// The error of J⁻¹ τ is at most 32 u ‖τ‖ / min I. Each of three body axes e has an error of at most 4 u, and enters
/// e (e·τ) twice. The products and sums cost at most 8 u.
TYPED_TEST(NotSlender, TurnsABodyAtTheBorderWithinItsBound) {
  using S = TypeParam;
  constexpr double u = std::numeric_limits<S>::epsilon() / 2;
  double worst = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    properties::Stream stream = properties::stream_from(i);
    const Vector3<S> moments = moments_at_the_border<S>(stream);
    const Quaternion<S> orientation = without_extreme_length<S>(stream.quaternion());
    const Vector3<S> torque = stream.direction().cast<S>();
    const auto inertia = PrincipalInertia<S>::of(moments, orientation);
    ASSERT_FALSE(is_slender(inertia)) << i;
    const Matrix3<Rational> inverse = world_inverse_inertia<Rational>(
        lifted(moments),
        {Rational(orientation[0]), Rational(orientation[1]), Rational(orientation[2]), Rational(orientation[3])});
    const double error =
        greatest_difference<S>(detail::turning_by(inertia, detail::in_body_frame(inertia, torque)).change_of_spin,
                               Vector3<Rational>(inverse * lifted(torque)));
    worst = std::max(worst, error / (u * static_cast<double>(torque.norm())));
  }
  std::cout << "worst error in u ‖τ‖ / min I: " << worst << '\n';
  EXPECT_GT(worst, 0);
  EXPECT_LT(worst, 32);
}

/// A body with moments 1 : x : 8 falls on a wall, and is struck nearly along its lever arm. K then has the eigenvalue λ
/// along N, and up to 16 λ across N, so rounding of the torque counts up to 15 times.
TYPED_TEST(NotSlender, HoldsTheRestitutionOfABodyAtTheBorder) {
  using S = TypeParam;
  constexpr double u = std::numeric_limits<S>::epsilon() / 2;
  double worst = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    properties::Stream stream = properties::stream_from(i);
    Contact<S> contact;
    const Vector3<double> direction = stream.direction().normalized();
    const double offset = stream.signed_unit() * std::ldexp(1.0, -stream.integer(0, 60));
    const Vector3<double> r = std::sqrt(15.0) * (direction + offset * Vector3<double>::Unit(stream.integer(0, 2)));
    contact.a = {
        S(1), PrincipalInertia<S>::of(moments_at_the_border<S>(stream), without_extreme_length<S>(stream.quaternion())),
        r.cast<S>(), (5 * direction).cast<S>(), Vector3<S>(stream.direction().cast<S>() * S(0.25))};
    contact.b = {S(0), PrincipalInertia<S>::immovable(), r.cast<S>(), Vector3<S>::Zero(), Vector3<S>::Zero()};
    contact.normal = -direction.cast<S>();
    contact.restitution = S(0.5);
    contact.friction = contact.tangential_restitution = S(0);
    const Contact<Rational> before = rounded<Rational>(contact);
    Contact<Rational> after = before;
    const Outcome<S> outcome = reflection(contact);
    after.a.velocity = lifted(outcome.a.velocity);
    after.a.angular_velocity = lifted(outcome.a.angular_velocity);
    const Rational left = normal_velocity(after) + Rational(contact.restitution) * normal_velocity(before);
    const double change = 1.5 * std::abs(oracles::to_double(normal_velocity(before)));
    worst = std::max(worst, std::abs(oracles::to_double(left)) / (u * change));
  }
  std::cout << "worst residual of N·V⁺ in u |N·ΔV|: " << worst << '\n';
  EXPECT_GT(worst, 0);
  EXPECT_LT(worst, 32);
}

/// Two uniform balls that approach each other. The lever arms are rounded, and then moved across N by `offset` radii.
template <class S>
Contact<S> touching_balls(properties::Stream& stream, double offset) {
  const Vector3<double> normal = stream.direction().normalized();
  const Vector3<double> across = normal.cross(Vector3<double>(stream.unit(), 2, -3)).normalized();
  const auto ball = [&](double side) {
    const double radius = stream.unit() + 0.5;
    const double mass = stream.unit() + 0.5;
    const Vector3<double> r = radius * (-side * normal + offset * across);
    const Vector3<double> v = -side * normal;
    const auto in_s = [](const Vector3<double>& x) { return Vector3<S>(x.template cast<S>()); };
    return ContactBody<S>{static_cast<S>(1 / mass),
                          PrincipalInertia<S>::of(in_s(Vector3<double>::Constant(0.4 * mass * radius * radius)),
                                                  without_extreme_length<S>(stream.quaternion())),
                          in_s(r), in_s(v), in_s(stream.direction())};
  };
  return {ball(1), ball(-1), normal.template cast<S>(), S(0.5), S(0), S(0)};
}

/// Rounding of r × N turns a ball by a few ulps. Such contacts need no collision matrix.
TYPED_TEST(NotSlender, ReflectsBallsByTheFrictionlessLaw) {
  using S = TypeParam;
  int turning = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    properties::Stream stream = properties::stream_from(i);
    const Contact<S> contact = touching_balls<S>(stream, 0);
    if (!detail::turns_no_body(contact, approach_of(contact))) {
      ++turning;
      continue;
    }
    EXPECT_EQ(reflection_impulse(contact).on_a, frictionless_impulse(contact).on_a) << i;
  }
  EXPECT_LT(turning, 20);
}

TYPED_TEST(NotSlender, TurnsBallsThatAreStruckASmallDistanceFromTheirRadius) {
  using S = TypeParam;
  constexpr double few_roundoffs = 16 * std::numeric_limits<S>::epsilon();
  for (std::uint64_t i = 0; i < 2000; ++i) {
    properties::Stream stream = properties::stream_from(i);
    const Contact<S> contact = touching_balls<S>(stream, few_roundoffs);
    EXPECT_FALSE(detail::turns_no_body(contact, approach_of(contact))) << i;
  }
}

/// |r × N| |r| of the wall overflows in float, but its J⁻¹ is 0.
TEST(TurnsNoBody, IgnoresTheLeverArmOfAFarWall) {
  properties::Stream stream = properties::stream_from(1);
  Contact<float> contact = touching_balls<float>(stream, 0.5);
  contact.b.inertia = PrincipalInertia<float>::immovable();
  contact.b.inverse_mass = 0;
  contact.b.lever_arm = {1e20F, 2e20F, 3e20F};
  EXPECT_FALSE(detail::turns_no_body(contact, approach_of(contact)));
}

/// In ℚ nothing is rounded, so the least turning counts.
TEST(TurnsNoBody, CountsTheLeastTurningInExactArithmetic) {
  Contact<Rational> contact = unit::exact_contact(unit::case_of("collinear_spheres", 1).collision);
  EXPECT_TRUE(detail::turns_no_body(contact, approach_of(contact)));
  contact.a.lever_arm += contact.normal.cross(Vector3<Rational>(1, 2, 3)) * unit::two_to(-2000);
  EXPECT_FALSE(detail::turns_no_body(contact, approach_of(contact)));
}

}  // namespace
}  // namespace carom::impulse
