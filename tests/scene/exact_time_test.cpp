// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/exact_time.hpp>

#include "paths.hpp"

namespace carom::scene {
namespace {

using unit::path_of;
using unit::Rational;
using unit::resting;
using unit::Vector;

const Vector at_rest = Vector::Zero();

TEST(ExactTime, OfMirroredPairsIsEqual) {
  // Two pairs that are mirror images, and one pair with its bodies exchanged. The times of contact are irrational.
  const Path middle = path_of({0, 0, 0}, {0, 0, 1}, at_rest, 0.3);
  const Path right = path_of({2, 0.25, 0.1}, {-1, 0, 1.125}, {0, 0, -0.5}, 0.7);
  const Path left = path_of({-2, 0.25, 0.1}, {1, 0, 1.125}, {0, 0, -0.5}, 0.7);
  const auto time_right = exact_contact(middle, right, 0);
  const auto time_left = exact_contact(middle, left, 0);
  const auto exchanged = exact_contact(right, middle, 0);
  ASSERT_TRUE(time_right && time_left && exchanged);
  EXPECT_EQ(*time_right, *time_left);
  EXPECT_EQ(*time_right, *exchanged);
  const TimeBounds bounds = time_right->bounds();
  EXPECT_EQ(bounds.latest, std::nextafter(bounds.earliest, never));  // adjacent doubles
}

TEST(ExactTime, OrdersInstantsThatDifferByLessThanAnUlp) {
  const Path wall = resting({0, 0, 0}, 0.5);
  const auto at = [&](double speed, double distance) {
    return exact_contact(wall, path_of({distance + 1, 0, 0}, {-speed, 0, 0}, at_rest, 0.5), 0);
  };
  const auto one = at(1, 1);
  ASSERT_TRUE(one);
  EXPECT_EQ(*one, ExactTime::at(1));
  const auto later_by = [&](double delay) {
    return exact_contact(wall, path_of({2 + delay, 0, 0}, {-1, 0, 0}, at_rest, 0.5), 0);
  };
  const auto later = later_by(0x1p-51);
  ASSERT_TRUE(later);
  EXPECT_LT(*one, *later);
  // Two contacts at the time 1/3, and the doubles next to 1/3.
  const auto third = at(3, 1);
  const auto also_third = at(1.5, 0.5);
  ASSERT_TRUE(third && also_third);
  EXPECT_EQ(*third, *also_third);
  EXPECT_LT(ExactTime::at(1.0 / 3), *third);
  EXPECT_GT(ExactTime::at(std::nextafter(1.0 / 3, 1)), *third);
  EXPECT_EQ(third->bounds().earliest, 1.0 / 3);
  EXPECT_EQ(third->bounds().latest, std::nextafter(1.0 / 3, 1));
}

TEST(ExactTime, HasTheAdjacentDoublesAsBounds) {
  properties::Stream stream = properties::stream_from(7);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const Path a = path_of(stream.vector(), stream.vector(), stream.vector(), 0.1, stream.unit());
    const Vector aside = 3 * stream.vector();
    // Aimed at the other body.
    const Path b = path_of(aside, position_at(a, 1) - aside, 0.25 * stream.vector(), 0.6);
    if (sign_of_gap(a, b, 0) <= 0) {
      continue;
    }
    const auto time = exact_contact(a, b, 0);
    if (!time) {
      continue;
    }
    ++found;
    const TimeBounds bounds = time->bounds();
    EXPECT_LE(ExactTime::at(bounds.earliest), *time);
    EXPECT_GE(ExactTime::at(bounds.latest), *time);
    EXPECT_TRUE(bounds.latest == bounds.earliest || bounds.latest == std::nextafter(bounds.earliest, never));
    EXPECT_GE(sign_of_gap(a, b, bounds.earliest), 0);
  }
  EXPECT_GT(found, 100);
}

/// The body moves at the smallest positive double, a speed that `keep_apart` can leave.
TEST(ExactTimeDeathTest, OfAContactLaterThanEveryDoubleHasBounds) {
  const Path creeping = path_of({3, 0, 0}, {-std::numeric_limits<double>::denorm_min(), 0, 0}, at_rest, 0.5);
  const Reach wall{{1, 0, 0}, 0.5};
  const auto contact = exact_contact(creeping, wall, 0);
  ASSERT_TRUE(contact);
  // The process ends by a signal if the contact has no bounds.
  EXPECT_EXIT(
      {
        const TimeBounds bounds = contact->bounds();
        std::exit(bounds.earliest == std::numeric_limits<double>::max() && bounds.latest == never ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST(ExactTime, OfATouchWithoutOverlapDoesNotExist) {
  const Path sphere = resting({0, 0, 0}, 0.5);
  EXPECT_FALSE(exact_contact(sphere, path_of({-3, 1, 0}, {1, 0, 0}, at_rest, 0.5), 0));
  // A parabola whose top touches the plane has no contact. With one ulp more speed it has a contact.
  const Reach ceiling{{0, 0, -1}, -2};
  EXPECT_FALSE(exact_contact(path_of({0, 0, 0}, {1, 0, 4}, {0, 0, -4}, 0.5), ceiling, 0));
  const auto hit = exact_contact(path_of({0, 0, 0}, {1, 0, std::nextafter(4.0, 5)}, {0, 0, -4}, 0.5), ceiling, 0);
  ASSERT_TRUE(hit);
  EXPECT_LT(*hit, ExactTime::at(1));
  EXPECT_TRUE(exact_contact(sphere, path_of({-3, std::nextafter(1.0, 0), 0}, {1, 0, 0}, at_rest, 0.5), 0));
  // The top of the parabola, x = −1, touches the sphere, so (s − 1)² is a factor of the squared gap.
  const Path top = path_of({-2, 0, 0}, {2, 0, 0}, {-2, 0, 0}, 0.5);
  EXPECT_EQ(sign_of_gap(top, sphere, 1), 0);
  EXPECT_FALSE(exact_contact(top, sphere, 0));
}

TEST(ExactTime, OfSpheresThatTouchIsThePresentIfTheyApproach) {
  const Path sphere = resting({0, 0, 0}, 0.5);
  const auto approaching = exact_contact(sphere, path_of({1, 0, 0}, {-1, 0, 0}, at_rest, 0.5), 0);
  ASSERT_TRUE(approaching);
  EXPECT_EQ(*approaching, ExactTime::at(0));
  EXPECT_FALSE(exact_contact(sphere, path_of({1, 0, 0}, {1, 0, 0}, at_rest, 0.5), 0));
  EXPECT_FALSE(exact_contact(sphere, path_of({1, 0, 0}, {0, 3, 0}, at_rest, 0.5), 0));
  EXPECT_FALSE(exact_contact(sphere, resting({1, 0, 0}, 0.5), 0));
  // The second sphere is at rest, but accelerates towards the first.
  const auto pressed = exact_contact(sphere, path_of({1, 0, 0}, {0, 0, 0}, {-1, 0, 0}, 0.5), 0);
  ASSERT_TRUE(pressed);
  EXPECT_EQ(*pressed, ExactTime::at(0));
  const auto later = exact_contact(sphere, path_of({2, 0, 0}, {-1, 0, 0}, at_rest, 0.5), 1);
  ASSERT_TRUE(later);
  EXPECT_EQ(*later, ExactTime::at(1));
  // A sphere that recedes returns because of its acceleration.
  const auto back = exact_contact(sphere, path_of({1, 0, 0}, {1, 0, 0}, {-2, 0, 0}, 0.5), 0);
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, ExactTime::at(1));
}

TEST(SignOfGap, IsThatOfRationalArithmetic) {
  properties::Stream stream = properties::stream_from(11);
  for (int i = 0; i < 300; ++i) {
    const Path a = path_of(stream.vector(), stream.vector(), stream.vector(), stream.unit(), stream.unit());
    Path b = path_of(2 * stream.vector(), stream.vector(), stream.vector(), stream.unit(), stream.unit());
    const double time = stream.between(0, 2);
    const unit::ExactVector d = unit::exact_position(a, time) - unit::exact_position(b, time);
    const Rational square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const auto expected = [&] {
      const Rational radii = Rational(a.radius) + Rational(b.radius);
      return unit::sign_of(square - radii * radii);
    };
    EXPECT_EQ(sign_of_gap(a, b, time), expected());
    // With this radius, the spheres nearly touch.
    b.radius = std::sqrt((position_at(a, time) - position_at(b, time)).squaredNorm()) - a.radius;
    if (b.radius > 0) {
      EXPECT_EQ(sign_of_gap(a, b, time), expected());
    }
  }
}

TEST(ReachOf, IsTheLeastDoubleThatIsClear) {
  properties::Stream stream = properties::stream_from(13);
  for (int i = 0; i < 300; ++i) {
    const Vector normal = stream.direction() * stream.power_of_ten(-3, 3);
    const Vector point = stream.vector() * stream.power_of_ten(-3, 3);
    const double radius = stream.between(0.01, 2);
    Rational level(0);
    Rational square(0);
    for (int axis = 0; axis < 3; ++axis) {
      level += Rational(normal[axis]) * Rational(point[axis]);
      square += Rational(normal[axis]) * Rational(normal[axis]) * Rational(radius) * Rational(radius);
    }
    const auto is_clear = [&](double x) {
      const Rational over = Rational(x) - level;
      return over >= 0 && over * over >= square;
    };
    const double reach = reach_of(normal, point, radius);
    EXPECT_TRUE(is_clear(reach));
    EXPECT_FALSE(is_clear(std::nextafter(reach, -never)));
  }
  EXPECT_EQ(reach_of({0, 0, 3}, {5, 7, 2}, 0.5), 7.5);
}

}  // namespace
}  // namespace carom::scene
