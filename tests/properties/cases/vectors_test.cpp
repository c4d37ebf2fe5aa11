// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <gtest/gtest.h>

#include <carom/properties/draws/vectors.hpp>

/// These tests use numbers that reveal the order of operations. For example, 2⁵³ + 1 rounds to 2⁵³. Fused or reordered
/// operations give other results.
namespace carom::properties {
namespace {

using V = Vector3<double>;

constexpr double big = 0x1p53;
constexpr double just_above_one = 1 + 0x1p-30;  // its square is 1 + 2⁻²⁹ + 2⁻⁶⁰, rounded 1 + 2⁻²⁹

TEST(Vectors, AddFromTheFirstToTheLast) {
  EXPECT_EQ(sum({big, 1, 1}), big);
  EXPECT_EQ(sum({1, 1, big}), big + 2);
  EXPECT_EQ(dot({big, 1, 1}, {1, 1, 1}), big);
  EXPECT_EQ(dot({1, 1, big}, {1, 1, 1}), big + 2);
  EXPECT_EQ(squared_length(Quaternion<double>(0x1p27, 1, 1, 1)), 0x1p54);
  EXPECT_EQ(squared_length(Quaternion<double>(1, 1, 1, 0x1p27)), 0x1p54 + 4);
  EXPECT_EQ(product({{big, 0, 0}, {1, 0, 0}, {1, 0, 0}}, {1, 1, 1}), V(big, 0, 0));
}

TEST(Vectors, RoundEachProduct) {
  const double square = 1 + 0x1p-29;
  EXPECT_EQ(dot({-square, just_above_one, 0}, {1, just_above_one, 0}), 0);         // fused: 2⁻⁶⁰
  EXPECT_EQ(plus({-square, 0, 0}, {just_above_one, 0, 0}, just_above_one)[0], 0);  // fused: 2⁻⁶⁰
  EXPECT_EQ(cross({0, just_above_one, just_above_one}, {0, just_above_one, just_above_one})[0], 0);
  EXPECT_EQ(cross({0, just_above_one, 1}, {0, square, just_above_one})[0], 0);  // fused: 2⁻⁶⁰
}

TEST(Vectors, ChooseTheFirstOfEquals) {
  EXPECT_EQ(place_of_least({2, 1, 1}), 1);
  EXPECT_EQ(place_of_least({1, 1, 1}), 0);
  EXPECT_EQ(place_of_least({3, 2, 1}), 2);
  EXPECT_EQ(least({3, -2, 1}), -2);
  EXPECT_EQ(greatest({3, -2, 5}), 5);
}

TEST(Vectors, TurnByQuaternionsOfAnyLength) {
  // Half a turn about x + y exchanges x and y. A quarter turn about z maps x to y.
  EXPECT_EQ(turned({0, 3, 3, 0}, {1, 2, 4}), V(2, 1, -4));
  const Quaternion<double> quarter(0.5, 0, 0, 0.5);
  EXPECT_EQ(turned(quarter, {1, 0, 0}), V(0, 1, 0));
  EXPECT_EQ(turned(conjugate(quarter), {0, 1, 0}), V(1, 0, 0));
  EXPECT_EQ(length({2, 3, 6}), 7);
}

TEST(Vectors, SolveAfterTheGreatestPivot) {
  // Each step of the elimination needs a row exchange, and no number is rounded.
  const Columns m{{0, 2, 4}, {1, 1, 2}, {2, 8, 4}};
  const V x{3, -1, 2};
  EXPECT_EQ(solution(m, product(m, x)), x);
  // Without the row exchange, 1 + 2⁶⁰ is rounded and the first unknown is lost.
  const Columns tiny{{0x1p-60, 1, 0}, {1, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(solution(tiny, {1, 2, 3}), V(1, 1, 3));
  EXPECT_FALSE(std::isfinite(solution({{1, 2, 4}, {2, 4, 8}, {0, 0, 1}}, {1, 1, 1})[0]));
}

}  // namespace
}  // namespace carom::properties
