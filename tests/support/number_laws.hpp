// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <carom/collision/vector.hpp>

#include "support/cases.hpp"

/// Tests of the field laws for any number type. A small file for each type specialises NumberType and instantiates the
/// suite.
namespace carom::unit {

/// The members of NumberType<T>:
///
///  static T draw(properties::Stream&)   a random number, sometimes zero
///  static bool is_zero(x)               whether x is or may be zero, so that it must not be a divisor
///
///  static bool same(x, y)               whether x and y, and their bounds, have the same bits
///  static bool same_value(x, y)         whether x and y have the same bits; their bounds may differ
///
///  static bool agrees(x, y, terms)      whether x and y can stand for the same real number
///  static double size(x)                about |x|; tests compute `terms` from sizes
///
/// For an exact type, `agrees` tests equality. For a type with bounds, `agrees` tests whether the bounds overlap. For a
/// type that rounds without a bound, `agrees` tests whether x and y differ by at most a few roundings of a number of
/// size `terms`.
template <class T>
struct NumberType;

template <class T>
class NumberLaws : public testing::Test {
 protected:
  template <class Visit>
  static void for_each_triple(const Visit& visit) {
    for (std::uint64_t i = 0; i < 400; ++i) {
      properties::Stream stream = properties::case_stream(seed, "number_laws", i);
      const T x = NumberType<T>::draw(stream);
      const T y = NumberType<T>::draw(stream);
      const T z = NumberType<T>::draw(stream);
      visit(x, y, z);
      ASSERT_FALSE(testing::Test::HasFailure()) << "triple " << i;
    }
  }

  static bool same(const T& x, const T& y) { return NumberType<T>::same(x, y); }
};

TYPED_TEST_SUITE_P(NumberLaws);

/// x + y and y + x have the same bits, even if they are rounded. Their bounds may differ.
TYPED_TEST_P(NumberLaws, CommuteBitForBit) {
  this->for_each_triple([&](const TypeParam& x, const TypeParam& y, const TypeParam&) {
    EXPECT_TRUE(NumberType<TypeParam>::same_value(x + y, y + x));
    EXPECT_TRUE(NumberType<TypeParam>::same_value(x * y, y * x));
  });
}

TYPED_TEST_P(NumberLaws, Associate) {
  using Type = NumberType<TypeParam>;
  this->for_each_triple([&](const TypeParam& x, const TypeParam& y, const TypeParam& z) {
    EXPECT_TRUE(Type::agrees((x + y) + z, x + (y + z), Type::size(x) + Type::size(y) + Type::size(z)));
    EXPECT_TRUE(Type::agrees((x * y) * z, x * (y * z), Type::size(x) * Type::size(y) * Type::size(z)));
  });
}

TYPED_TEST_P(NumberLaws, Distribute) {
  using Type = NumberType<TypeParam>;
  this->for_each_triple([&](const TypeParam& x, const TypeParam& y, const TypeParam& z) {
    EXPECT_TRUE(Type::agrees(x * (y + z), x * y + x * z, Type::size(x) * (Type::size(y) + Type::size(z))));
    EXPECT_TRUE(Type::agrees((x - y) * z, x * z - y * z, (Type::size(x) + Type::size(y)) * Type::size(z)));
  });
}

TYPED_TEST_P(NumberLaws, HaveNeutralNumbers) {
  using Type = NumberType<TypeParam>;
  const TypeParam zero(0);
  const TypeParam one(1);
  EXPECT_TRUE(this->same(TypeParam(), zero));
  this->for_each_triple([&](const TypeParam& x, const TypeParam&, const TypeParam&) {
    EXPECT_TRUE(Type::agrees(x + zero, x, Type::size(x)));
    EXPECT_TRUE(Type::agrees(x * one, x, Type::size(x)));
    EXPECT_TRUE(Type::agrees(x / one, x, Type::size(x)));
    EXPECT_TRUE(this->same(x * zero, zero));
  });
}

TYPED_TEST_P(NumberLaws, HaveInverses) {
  using Type = NumberType<TypeParam>;
  this->for_each_triple([&](const TypeParam& x, const TypeParam& y, const TypeParam&) {
    EXPECT_TRUE(Type::agrees(x + (-x), TypeParam(0), Type::size(x)));
    EXPECT_TRUE(this->same(-(-x), x));
    EXPECT_TRUE(this->same(x - y, x + (-y)));
    if (!Type::is_zero(y)) {
      EXPECT_TRUE(Type::agrees(y / y, TypeParam(1), 1));
      EXPECT_TRUE(Type::agrees(x / y * y, x, Type::size(x)));
      EXPECT_TRUE(Type::agrees(x / y, x * (TypeParam(1) / y), Type::size(x) / Type::size(y)));
    }
  });
}

TYPED_TEST_P(NumberLaws, ContainTheIntegers) {
  for (int i = -9; i <= 9; ++i) {
    for (int j = -9; j <= 9; ++j) {
      const TypeParam x(i);
      const TypeParam y(j);
      EXPECT_TRUE(NumberType<TypeParam>::agrees(x + y, TypeParam(i + j), 0)) << i << ' ' << j;
      EXPECT_TRUE(NumberType<TypeParam>::agrees(x - y, TypeParam(i - j), 0)) << i << ' ' << j;
      EXPECT_TRUE(NumberType<TypeParam>::agrees(x * y, TypeParam(i * j), 0)) << i << ' ' << j;
      // `agrees` must reject different numbers.
      EXPECT_FALSE(NumberType<TypeParam>::agrees(x + y, TypeParam(i + j + 1), 1)) << i << ' ' << j;
    }
  }
}

/// `x += y` gives x + y, and `x += x` gives x + x.
TYPED_TEST_P(NumberLaws, AssignAsTheyComputeAlsoToThemselves) {
  this->for_each_triple([&](const TypeParam& x, const TypeParam& y, const TypeParam&) {
    const auto expect_same = [&](const auto& assign, const auto& compute, bool divides) {
      if (!divides || !NumberType<TypeParam>::is_zero(y)) {
        TypeParam assigned = x;
        EXPECT_TRUE(this->same(assign(assigned, y), compute(x, y)));
      }
      if (!divides || !NumberType<TypeParam>::is_zero(x)) {
        TypeParam own = x;
        EXPECT_TRUE(this->same(assign(own, own), compute(x, x)));
      }
    };
    expect_same([](TypeParam& to, const TypeParam& by) { return to += by; }, std::plus<>(), false);
    expect_same([](TypeParam& to, const TypeParam& by) { return to -= by; }, std::minus<>(), false);
    expect_same([](TypeParam& to, const TypeParam& by) { return to *= by; }, std::multiplies<>(), false);
    expect_same([](TypeParam& to, const TypeParam& by) { return to /= by; }, std::divides<>(), true);
  });
}

/// For Eigen vectors, (x × y)·z = x·(y × z) and x × x = 0.
TYPED_TEST_P(NumberLaws, GoThroughEigen) {
  using Type = NumberType<TypeParam>;
  for (std::uint64_t i = 0; i < 100; ++i) {
    properties::Stream stream = properties::case_stream(seed, "number_laws in vectors", i);
    const auto draw = [&] {
      Vector3<TypeParam> vector;
      for (int k = 0; k < 3; ++k) {
        vector[k] = Type::draw(stream);
      }
      return vector;
    };
    const auto size = [](const Vector3<TypeParam>& vector) {
      return Type::size(vector[0]) + Type::size(vector[1]) + Type::size(vector[2]);
    };
    const Vector3<TypeParam> x = draw();
    const Vector3<TypeParam> y = draw();
    const Vector3<TypeParam> z = draw();
    const Vector3<TypeParam> nothing = x.cross(x);
    EXPECT_TRUE(Type::agrees(x.cross(y).dot(z), x.dot(y.cross(z)), size(x) * size(y) * size(z))) << i;
    EXPECT_TRUE(Type::agrees(nothing[i % 3], TypeParam(0), size(x) * size(x))) << i;
  }
}

REGISTER_TYPED_TEST_SUITE_P(NumberLaws, CommuteBitForBit, Associate, Distribute, HaveNeutralNumbers, HaveInverses,
                            ContainTheIntegers, AssignAsTheyComputeAlsoToThemselves, GoThroughEigen);

}  // namespace carom::unit
