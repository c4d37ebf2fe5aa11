// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include <carom/scene/placing.hpp>
#include <carom/scene/prediction.hpp>

#include "paths.hpp"

namespace carom::scene {
namespace {

using unit::path_of;
using unit::Rational;
using unit::Vector;

TEST(RoundedAway, GivesAPositionNoNearerThanThePath) {
  properties::Stream stream = properties::stream_from(1);
  int moved = 0;
  for (int i = 0; i < 2000; ++i) {
    const Path path =
        path_of(stream.vector() * stream.power_of_ten(-2, 2), stream.vector(), stream.vector(), 0.5, stream.unit());
    const double time = path.start + stream.unit();
    const Vector away = stream.chance(4) ? Vector(0, 0, 0) : stream.vector();
    const Vector rounded = rounded_away(path, time, away);
    const unit::ExactVector exact = unit::exact_position(path, time);
    for (int axis = 0; axis < 3; ++axis) {
      const Rational over = Rational(rounded[axis]) - exact[axis];
      if (away[axis] > 0) {
        EXPECT_TRUE(over >= 0);
      } else if (away[axis] < 0) {
        EXPECT_TRUE(over <= 0);
      }
      const double ulp = std::nextafter(std::abs(rounded[axis]), never) - std::abs(rounded[axis]);
      EXPECT_TRUE((over >= 0 ? over : -over) <= Rational(2) * Rational(ulp) || std::abs(rounded[axis]) < 1e-3);
      moved += away[axis] != 0 && over != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 1000);
}

/// v + s a/2 is zero in long double, but not exactly. So after the time s, the body is almost back at its start.
TEST(RoundedAway, GivesAPositionNoNearerThanAPathThatHasAlmostReturned) {
  properties::Stream stream = properties::stream_from(4);
  int returned = 0;
  for (int i = 0; i < 100000; ++i) {
    const double time = stream.between(0.25, 1);
    const double acceleration = stream.between(4, 10);
    const long double half = static_cast<long double>(time) * acceleration / 2;
    const double velocity = -static_cast<double>(half);
    if (static_cast<long double>(velocity) != -half) {
      continue;  // only one in 2¹¹ is a double
    }
    const Path path = path_of({1, 0, 0}, {velocity, 0, 0}, {acceleration, 0, 0}, 0.5);
    const Rational exact = unit::exact_position(path, time)[0];
    ++returned;
    EXPECT_TRUE(Rational(rounded_away(path, time, {1, 0, 0})[0]) >= exact);
    EXPECT_TRUE(Rational(rounded_away(path, time, {-1, 0, 0})[0]) <= exact);
  }
  EXPECT_GT(returned, 10);
}

TEST(RoundedAway, LeavesAPositionThatDoesNotMove) {
  const Path still = path_of({0.1, 0.2, 0.3}, {0, 0, 0}, {0, 0, 0}, 1);
  EXPECT_EQ(rounded_away(still, 7, {1, -1, 1}), still.position);
  const Path starting = path_of({0.1, 0.2, 0.3}, {1, 2, 3}, {4, 5, 6}, 1, 7);
  EXPECT_EQ(rounded_away(starting, 7, {1, -1, 1}), starting.position);
}

TEST(Overlap, IsDecidedAsByTheExactSignOfTheGap) {
  properties::Stream stream = properties::stream_from(3);
  unsigned long long undecided = 0;
  int overlapping = 0;
  for (int i = 0; i < 500; ++i) {
    const Path a = path_of(stream.vector(), stream.vector(), stream.vector(), stream.unit(), stream.unit());
    Path b = path_of(stream.vector(), stream.vector(), stream.vector(), 0.1, stream.unit());
    const double time = 1 + stream.unit();
    const double distance = (position_at(a, time) - position_at(b, time)).norm();
    b.radius = distance - a.radius + stream.integer(-2, 2) * 0x1p-52;
    if (!(b.radius > 0)) {
      continue;
    }
    EXPECT_EQ(overlap(a, b, time, undecided), sign_of_gap(a, b, time) < 0);
    overlapping += overlap(a, b, time, undecided) ? 1 : 0;
    const Vector normal = stream.direction();
    const Reach plane{normal, normal.dot(position_at(a, time)) + stream.integer(-2, 2) * 0x1p-53};
    EXPECT_EQ(overlap(a, plane, time, undecided), sign_of_gap(a, plane, time) < 0);
  }
  EXPECT_GT(undecided, 100U);  // bounds do not decide these cases
  EXPECT_GT(overlapping, 50);
}

TEST(MovedByUlps, GivesEachMoveOnceAndTheShortestFirst) {
  const Vector position{1.5, -2.5, 1e-3};
  EXPECT_EQ(moved_by_ulps(position, 0), position);
  std::set<std::tuple<double, double, double>> seen;
  int before = 0;
  for (int k = 0; k < moves; ++k) {
    const Vector moved = moved_by_ulps(position, k);
    EXPECT_TRUE(seen.insert({moved.x(), moved.y(), moved.z()}).second);
    int size = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double ulp = std::nextafter(std::abs(position[axis]), never) - std::abs(position[axis]);
      const auto steps = static_cast<int>(std::lround((moved[axis] - position[axis]) / ulp));
      EXPECT_LE(std::abs(steps), 3);
      size += steps * steps;
    }
    EXPECT_GE(size, before);
    before = size;
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(moves));
}

}  // namespace
}  // namespace carom::scene
