// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>

/// Operations on vectors of doubles, for families and features. Each operation is rounded separately, in the order
/// given here, so that the same integers give the same collision on every machine. The order of Eigen's sums (dot,
/// norm, products of matrices) depends on the instruction set, so families and features do not use these sums.
namespace carom::properties {

/// (u₀ v₀ + u₁ v₁) + u₂ v₂.
[[nodiscard]] double dot(const Vector3<double>& u, const Vector3<double>& v);

/// u₁ v₂ − u₂ v₁ and its cyclic permutations; each product is rounded.
[[nodiscard]] Vector3<double> cross(const Vector3<double>& u, const Vector3<double>& v);

/// Changes each sign, also of zero. Eigen's −v is 0 − v if it uses wide packets, and 0 − 0 is not −0.
[[nodiscard]] Vector3<double> negated(const Vector3<double>& v);
[[nodiscard]] Quaternion<double> negated(const Quaternion<double>& q);

/// (v₀ + v₁) + v₂.
[[nodiscard]] double sum(const Vector3<double>& v);

[[nodiscard]] double squared_length(const Vector3<double>& v);
[[nodiscard]] double length(const Vector3<double>& v);

/// ((w² + x²) + y²) + z².
[[nodiscard]] double squared_length(const Quaternion<double>& q);

/// The least and the greatest component.
[[nodiscard]] double least(const Vector3<double>& v);
[[nodiscard]] double greatest(const Vector3<double>& v);

/// The index of the least component; the first index if several components are equal.
[[nodiscard]] int place_of_least(const Vector3<double>& v);

/// v + s u. The product is rounded, then the sum.
[[nodiscard]] Vector3<double> plus(const Vector3<double>& v, const Vector3<double>& u, double s);

/// v rotated by q, a quaternion of any nonzero length: q v q* / ‖q‖².
[[nodiscard]] Vector3<double> turned(const Quaternion<double>& q, const Vector3<double>& v);

/// The quaternion of the inverse rotation.
[[nodiscard]] Quaternion<double> conjugate(const Quaternion<double>& q);

/// A 3 × 3 matrix by its columns.
struct Columns {
  Vector3<double> x;
  Vector3<double> y;
  Vector3<double> z;
};

/// M v: (x v₀ + y v₁) + z v₂.
[[nodiscard]] Vector3<double> product(const Columns& m, const Vector3<double>& v);

/// M⁻¹ v by Gaussian elimination. The pivot of each column is its largest element by magnitude, or the first of equal
/// elements. If M is singular, components of the result are not finite.
[[nodiscard]] Vector3<double> solution(const Columns& m, const Vector3<double>& v);

/// A vector exactly orthogonal to this one: two components are exchanged and one is negated. Nonzero for a nonzero
/// vector.
[[nodiscard]] Vector3<double> orthogonal(const Vector3<double>& vector);

}  // namespace carom::properties
