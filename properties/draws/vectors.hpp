// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/collision/vector.hpp>

/// Vector operations for families and features. Each operation is rounded separately in the order given here, so
/// results are the same on every machine. Do not use Eigen's dot, norm and matrix products for families and features:
/// the order of their sums depends on the instruction set.
namespace carom::properties {

/// (u₀ v₀ + u₁ v₁) + u₂ v₂.
[[nodiscard]] double dot(const Vector3<double>& u, const Vector3<double>& v);

/// u₁ v₂ − u₂ v₁ and its cyclic permutations. Each product is rounded.
[[nodiscard]] Vector3<double> cross(const Vector3<double>& u, const Vector3<double>& v);

/// Changes each sign, also that of zero. Eigen's −v may compute 0 − v (with wide packets), and 0 − 0 is not −0.
[[nodiscard]] Vector3<double> negated(const Vector3<double>& v);
[[nodiscard]] Quaternion<double> negated(const Quaternion<double>& q);

/// (v₀ + v₁) + v₂.
[[nodiscard]] double sum(const Vector3<double>& v);

[[nodiscard]] double squared_length(const Vector3<double>& v);
[[nodiscard]] double length(const Vector3<double>& v);

/// ((w² + x²) + y²) + z².
[[nodiscard]] double squared_length(const Quaternion<double>& q);

[[nodiscard]] double least(const Vector3<double>& v);
[[nodiscard]] double greatest(const Vector3<double>& v);

/// The first index of the least component.
[[nodiscard]] int place_of_least(const Vector3<double>& v);

/// v + s u. The product is rounded, then the sum.
[[nodiscard]] Vector3<double> plus(const Vector3<double>& v, const Vector3<double>& u, double s);

/// v rotated by a quaternion q of any nonzero length: q v q* / ‖q‖².
[[nodiscard]] Vector3<double> turned(const Quaternion<double>& q, const Vector3<double>& v);

/// The inverse rotation.
[[nodiscard]] Quaternion<double> conjugate(const Quaternion<double>& q);

struct Columns {
  Vector3<double> x;
  Vector3<double> y;
  Vector3<double> z;
};

/// M v: (x v₀ + y v₁) + z v₂.
[[nodiscard]] Vector3<double> product(const Columns& m, const Vector3<double>& v);

/// M⁻¹ v by Gaussian elimination. The pivot of a column is its first largest element by magnitude. If M is singular,
/// the result has components that are not finite.
[[nodiscard]] Vector3<double> solution(const Columns& m, const Vector3<double>& v);

/// A vector exactly orthogonal to this one: two components are exchanged, and one of these is negated. Zero only for
/// zero.
[[nodiscard]] Vector3<double> orthogonal(const Vector3<double>& vector);

/// The number, rounded to this many bits. Preconditions: the number is finite; `bits` is positive.
[[nodiscard]] inline double rounded_to_bits(double number, int bits) {
  int exponent = 0;
  const double mantissa = std::frexp(number, &exponent);
  return std::ldexp(std::round(std::ldexp(mantissa, bits)), exponent - bits);
}

}  // namespace carom::properties
