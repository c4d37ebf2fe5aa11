// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>

/// Vectors of doubles, for families and features. Every operation is rounded by itself, in the order that is stated
/// here, so that the same integers give the same collision on every machine. Eigen takes its own sums (dot, norm,
/// products of matrices) in an order that depends on the instruction set: families and features use none of them.
namespace carom::properties {

/// (u₀ v₀ + u₁ v₁) + u₂ v₂.
[[nodiscard]] double dot(const Vector3<double>& u, const Vector3<double>& v);

/// u₁ v₂ − u₂ v₁, and so on in turn; each product is rounded.
[[nodiscard]] Vector3<double> cross(const Vector3<double>& u, const Vector3<double>& v);

/// Each sign is changed, also of zero: Eigen's −v is 0 − v where packets are wide, and 0 − 0 is not −0.
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

/// The place of the least component, the first of equal ones.
[[nodiscard]] int place_of_least(const Vector3<double>& v);

/// v + s u: the product is rounded, and then the sum.
[[nodiscard]] Vector3<double> plus(const Vector3<double>& v, const Vector3<double>& u, double s);

/// v turned by the rotation that q stands for, of any nonzero length: q v q* / ‖q‖².
[[nodiscard]] Vector3<double> turned(const Quaternion<double>& q, const Vector3<double>& v);

/// The rotation the other way round.
[[nodiscard]] Quaternion<double> conjugate(const Quaternion<double>& q);

/// Three columns.
struct Columns {
  Vector3<double> x;
  Vector3<double> y;
  Vector3<double> z;
};

/// M v: (x v₀ + y v₁) + z v₂.
[[nodiscard]] Vector3<double> product(const Columns& m, const Vector3<double>& v);

/// M⁻¹ v by Gaussian elimination, the pivot of each column its greatest number, the first of equal ones. Where M is
/// singular the numbers are not finite.
[[nodiscard]] Vector3<double> solution(const Columns& m, const Vector3<double>& v);

/// A vector orthogonal to this one, exactly: two components exchanged, one negated. Never zero for a nonzero vector.
[[nodiscard]] Vector3<double> orthogonal(const Vector3<double>& vector);

}  // namespace carom::properties
