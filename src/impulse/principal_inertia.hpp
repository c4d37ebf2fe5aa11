// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/numbers/difference_of_products.hpp>
#include <carom/impulse/numbers/products.hpp>
#include <carom/impulse/rotation.hpp>
#include <carom/impulse/select.hpp>
#include <carom/impulse/turning.hpp>

namespace carom::impulse {

/// J⁻¹ = R diag(1/I) Rᵀ in its parts. Torques are turned into the body frame, divided there by the principal moments,
/// and turned back, so that each principal component has a relative error of its own. As one matrix in world
/// coordinates (world_inertia.hpp) the greatest component rounds all others: that costs the angular momentum of a body
/// with moments 1 : ρ up to ρ/10 ulps. What is known not to be slender (below) needs less: `may_be_slender` is false.
template <class S, bool may_be_slender = true>
struct PrincipalInertia {
  Matrix3<S> axes;             // its columns are the body axes, of unit length, in world coordinates
  Vector3<S> inverse_moments;  // 1/I about the centre of mass along them; 0 where immovable [1/(kg m²)]

  /// Where the moments are equal every axis is a body axis, and those of the world are not rounded.
  static PrincipalInertia of(const Vector3<S>& moments, const Quaternion<S>& orientation) {
    const bool is_isotropic = moments[0] == moments[1] && moments[1] == moments[2];
    return {is_isotropic ? Matrix3<S>::Identity() : rotation_matrix(orientation),
            Vector3<S>{S(1) / moments[0], S(1) / moments[1], S(1) / moments[2]}};
  }
  static PrincipalInertia immovable() { return {Matrix3<S>::Constant(S(0)), Vector3<S>::Constant(S(0))}; }
};

namespace detail {

template <class S>
[[nodiscard]] Vector3<S> products_of_components(const Vector3<S>& x, const Vector3<S>& y) {
  return {x[0] * y[0], x[1] * y[1], x[2] * y[2]};
}

/// |x| + |y| + |z|.
template <class S>
[[nodiscard]] S sum_of_sizes(const Vector3<S>& v) {
  return (absolute(v[0]) + absolute(v[1])) + absolute(v[2]);
}

}  // namespace detail

/// From this ratio of moments on a body counts as slender: up to here plain products lose some 4 ulps at most.
inline constexpr int least_ratio_of_slender_moments = 8;

/// Whether the moments are further apart. Of the product of vectors along each other rounding leaves u |x| |y|, by
/// which the long axis of a body with moments 1 : ρ is turned ρ times as far as the others.
template <class S, bool may_be_slender>
[[nodiscard]] auto is_slender(const PrincipalInertia<S, may_be_slender>& inertia) {
  if constexpr (may_be_slender) {
    const S& x = inertia.inverse_moments[0];
    const S& y = inertia.inverse_moments[1];
    const S& z = inertia.inverse_moments[2];
    const S greatest = at_least(at_least(x, y), z);
    const S least = -at_least(at_least(S(-x), S(-y)), S(-z));
    return S(least_ratio_of_slender_moments) * least < greatest;
  } else {
    return false;
  }
}

/// The matrix whose rows are e × r for the body axes e: times F it is Rᵀ (r × F).
template <class S, bool may_be_slender>
[[nodiscard]] Matrix3<S> moments_of_unit_impulses(const PrincipalInertia<S, may_be_slender>& inertia,
                                                  const Vector3<S>& r) {
  const auto rows_by = [&](const auto& product) {
    Matrix3<S> rows;
    for (int k = 0; k < 3; ++k) {
      rows.row(k) = product(Vector3<S>(inertia.axes.col(k)));
    }
    return rows;
  };
  return select_called(
      is_slender(inertia), [&] { return rows_by([&](const Vector3<S>& e) { return accurate_cross(e, r); }); },
      [&] { return rows_by([&](const Vector3<S>& e) { return cross(e, r); }); });
}

/// Rᵀ (r × F), the torque in body coordinates. About an axis e it is taken as (e × r)·F, which is what K is made of:
/// then an impulse does what K says, however slender the body is. Where F lies along r but for rounding, or nearly, it
/// is e·(r × F), of which nothing is left where nothing should be, and which both bodies share that turn about one
/// place: `has_slender` is whether any body of the contact is.
template <class S, bool may_be_slender, class Condition>
[[nodiscard]] Vector3<S> torque_in_body_frame(const PrincipalInertia<S, may_be_slender>& inertia, const Vector3<S>& r,
                                              const Vector3<S>& impulse, const Condition& has_slender) {
  const Vector3<S> torque = select_called(
      has_slender, [&] { return accurate_cross(r, impulse); }, [&] { return cross(r, impulse); });
  constexpr int nearly = 4096;  // times as much is between what rounding makes of r × F and what is there by chance
  const auto is_along =
      S(nearly) * detail::sum_of_sizes(torque) < detail::sum_of_sizes(r) * detail::sum_of_sizes(impulse);
  return select_called(
      is_along,
      [&] {
        return Vector3<S>{dot<S>(inertia.axes.col(0), torque), dot<S>(inertia.axes.col(1), torque),
                          dot<S>(inertia.axes.col(2), torque)};
      },
      [&] { return times(moments_of_unit_impulses(inertia, r), impulse); });
}

/// Both parts are of one torque, so that an impulse along F turns the body as much as it was expected to.
template <class S, bool may_be_slender, class Condition>
[[nodiscard]] Turning<S> turning(const PrincipalInertia<S, may_be_slender>& inertia, const Vector3<S>& r,
                                 const Vector3<S>& impulse, const Condition& has_slender) {
  const Vector3<S> torque = torque_in_body_frame(inertia, r, impulse, has_slender);
  const Vector3<S> divided = detail::products_of_components(torque, inertia.inverse_moments);
  return {times(inertia.axes, divided), dot(divided, torque)};
}

/// [r]ᵀ J⁻¹ [r] = Σ (e × r)(e × r)ᵀ / I over the body axes e, with [r] x = r × x. Exactly symmetric.
template <class S, bool may_be_slender>
[[nodiscard]] Matrix3<S> angular_part_of_collision_matrix(const PrincipalInertia<S, may_be_slender>& inertia,
                                                          const Vector3<S>& r) {
  const Matrix3<S> moments = moments_of_unit_impulses(inertia, r);
  Matrix3<S> matrix;
  for (int column = 0; column < 3; ++column) {
    const Vector3<S> divided = detail::products_of_components<S>(moments.col(column), inertia.inverse_moments);
    for (int row = column; row < 3; ++row) {
      matrix(row, column) = dot<S>(moments.col(row), divided);
      matrix(column, row) = matrix(row, column);
    }
  }
  return matrix;
}

}  // namespace carom::impulse
