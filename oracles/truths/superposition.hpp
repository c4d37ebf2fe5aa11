// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <span>
#include <type_traits>

#include <carom/collision/expects.hpp>
#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/laws/kinematics.hpp>

/// The exact outcome by superposition: the velocities respond linearly to the impulse. T is a field.
namespace carom::oracles {

/// The solution of M x = b for a symmetric positive definite M = L D Lᵀ. The relative error is about u times the
/// condition number of M. Cramer's rule loses a higher power of this number (N. Higham, Accuracy and Stability of
/// Numerical Algorithms, §10.1 and §1.10.1).
template <class S>
class DefiniteSystem {
 public:
  explicit DefiniteSystem(const Matrix3<S>& m)
      : l10_(m(1, 0) / m(0, 0)), l20_(m(2, 0) / m(0, 0)), d0_(m(0, 0)), d1_(m(1, 1) - l10_ * m(1, 0)) {
    const S rest = m(2, 1) - l20_ * m(1, 0);
    l21_ = rest / d1_;
    d2_ = m(2, 2) - l20_ * m(2, 0) - l21_ * rest;
  }

  [[nodiscard]] Vector3<S> solve(const Vector3<S>& b) const {
    const S y1 = b[1] - l10_ * b[0];
    const S y2 = b[2] - l20_ * b[0] - l21_ * y1;
    const S x2 = y2 / d2_;
    const S x1 = y1 / d1_ - l21_ * x2;
    return {b[0] / d0_ - l10_ * x1 - l20_ * x2, x1, x2};
  }

 private:
  S l10_, l20_, l21_;  // L below its diagonal of ones
  S d0_, d1_, d2_;     // D
};

/// The change of a body's velocities by the impulse F at the contact point. It is zero if the body is immovable.
template <class T>
[[nodiscard]] BodyVelocity<T> response(const BasicBody<T>& body, const Vector3<T>& point, const Vector3<T>& impulse) {
  if (body.immovable) {
    return {Vector3<T>{T(0), T(0), T(0)}, Vector3<T>{T(0), T(0), T(0)}};
  }
  const Vector3<T> arm = lever_arm(body, point);
  return {impulse / body.mass, mapped_linearly(impulse, [&](const Vector3<T>& f) {
            const Vector3<T> angular_impulse = turned<T>(conjugate(body.orientation), arm.cross(f));
            return turned<T>(body.orientation, angular_impulse.cwiseQuotient(body.principal_inertia));
          })};
}

/// The change of all velocities by F on A and −F on B.
template <class T>
[[nodiscard]] Outcome<T> response(const BasicCollision<T>& collision, const Vector3<T>& impulse) {
  return {response<T>(collision.a, collision.point, impulse),
          response<T>(collision.b, collision.point, Vector3<T>(-impulse))};
}

/// The collision matrix by its definition: column i is the change of relative velocity by a unit impulse along axis i.
template <class T>
[[nodiscard]] Matrix3<T> response_matrix(const BasicCollision<T>& collision) {
  Matrix3<T> matrix;
  for (int i = 0; i < 3; ++i) {
    Vector3<T> unit{T(0), T(0), T(0)};
    unit[i] = T(1);
    matrix.col(i) = relative_velocity<T>(collision, response<T>(collision, unit));
  }
  return matrix;
}

namespace detail {

template <class T>
[[nodiscard]] Vector3<T> cramers_rule(const Matrix3<T>& m, const Vector3<T>& b) {
  const Vector3<T> c0 = m.col(0);
  const Vector3<T> c1 = m.col(1);
  const Vector3<T> c2 = m.col(2);
  const Vector3<T> c12 = c1.cross(c2);
  const T determinant = c0.dot(c12);
  if constexpr (std::equality_comparable<T>) {
    CAROM_EXPECTS(determinant != T(0));
  }
  return Vector3<T>{b.dot(c12), b.dot(c2.cross(c0)), b.dot(c0.cross(c1))} / determinant;
}

}  // namespace detail

/// The solution of M x = b by Cramer's rule. Of fractions, d M with the common denominator d takes the place of M.
/// Precondition: M is regular.
template <class T>
[[nodiscard]] Vector3<T> cramer(const Matrix3<T>& m, const Vector3<T>& b) {
  if constexpr (Fraction<T>) {
    const T denominator(common_denominator(std::span<const T>(m.data(), 9)));
    const Matrix3<T> whole = m * denominator;
    return mapped_linearly(b, [&](const Vector3<T>& x) { return detail::cramers_rule<T>(whole, x); }) * denominator;
  } else {
    return detail::cramers_rule<T>(m, b);
  }
}

/// F with K F = change. `matrix` is K, or nullptr if K is not known. Precondition: a body is movable.
template <class T>
[[nodiscard]] Vector3<T> impulse_by_matrix(const BasicCollision<T>& collision, const Vector3<T>& change,
                                           const Matrix3<T>* matrix) {
  CAROM_EXPECTS(has_movable_body(collision));
  const Matrix3<T> k = matrix != nullptr ? *matrix : response_matrix(collision);
  if constexpr (std::is_same_v<T, Enclosure> || std::is_same_v<T, double>) {
    return DefiniteSystem<T>(k).solve(change);
  } else {
    return cramer<T>(k, change);  // rationals lose no digits
  }
}

/// The change of relative velocity that restitution causes along the normal: −(1 + ε) (N·V⁻) / (N·N) N.
template <class T>
[[nodiscard]] Vector3<T> change_by_restitution(const Vector3<T>& n, const T& restitution,
                                               const Vector3<T>& velocity_before) {
  const T wanted = -(T(1) + restitution) * n.dot(velocity_before);
  return n * T(wanted / n.dot(n));
}

template <class T>
[[nodiscard]] Outcome<T> sum(const Outcome<T>& x, const Outcome<T>& y) {
  return {{x.a.velocity + y.a.velocity, x.a.angular_velocity + y.a.angular_velocity},
          {x.b.velocity + y.b.velocity, x.b.angular_velocity + y.b.angular_velocity}};
}

}  // namespace carom::oracles
