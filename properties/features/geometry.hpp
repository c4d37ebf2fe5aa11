// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/stream.hpp>
#include <carom/properties/draws/vectors.hpp>

namespace carom::properties::features {

/// Masses that features may set [kg]. They begin at the least decade of the feature `mass_1e-9`, and end with the last
/// one, `mass_1e9`. They bound the drawn masses, and not the judged ones.
inline constexpr double least_mass = 1e-9;
inline constexpr double largest_mass = 1e10;

/// r = P − X, rounded [m].
[[nodiscard]] inline Vector3<double> lever_arm(const Collision& collision, const Body& body) {
  return collision.point - body.position;
}

[[nodiscard]] inline bool is_zero(const Vector3<double>& v) { return (v.array() == 0).all(); }

[[nodiscard]] inline bool is_at_rest(const Body& body) {
  return is_zero(body.velocity) && is_zero(body.angular_velocity);
}

/// Whether both vectors are nonzero and one is exactly a multiple of the other.
[[nodiscard]] bool are_parallel(const Vector3<double>& u, const Vector3<double>& v);

/// Whether both vectors are nonzero and their rounded dot product is 0.
[[nodiscard]] inline bool are_orthogonal(const Vector3<double>& u, const Vector3<double>& v) {
  return !is_zero(u) && !is_zero(v) && dot(u, v) == 0;
}

[[nodiscard]] inline int nonzero_components(const Vector3<double>& v) {
  return static_cast<int>((v.array() != 0).count());
}

/// Whether two components are equal up to the sign, and not zero.
[[nodiscard]] bool has_ties(const Vector3<double>& v);

/// v rounded to eight bits in each component, so sums and products are exact.
[[nodiscard]] Vector3<double> with_few_bits(const Vector3<double>& v);

/// A power of two near ‖v‖; 1 for the zero vector.
[[nodiscard]] double size_of(const Vector3<double>& v);

/// An exact multiple of `direction`, about as long as v.
[[nodiscard]] Vector3<double> turned_along(const Vector3<double>& v, const Vector3<double>& direction);

/// A vector about as long as v, and exactly orthogonal to a direction of few bits.
[[nodiscard]] Vector3<double> turned_across(Stream& stream, const Vector3<double>& v, const Vector3<double>& direction);

/// Makes one component zero, and the others nonzero.
void put_in_plane(Stream& stream, Vector3<double>& v);

/// Multiplies the mass and the moments of inertia.
void scale_mass(Body& body, double by);
void set_mass(Body& body, double mass);

/// √((I₁ + I₂ + I₃) / 2m), the root mean square distance of the mass from its centre [m]; 0 for an immovable body.
[[nodiscard]] double radius_of_gyration(const Body& body);

/// The lesser radius of gyration of the movable bodies [m]; 0 if both are immovable.
[[nodiscard]] double least_radius_of_gyration(const Collision& collision);

/// The greatest |e × r| / (2√(I/m)) over the principal axes e, with the moment I about e; 0 for an immovable body. If
/// it is far above 1, the collision matrix is ill-conditioned.
[[nodiscard]] double overreach(const Collision& collision, const Body& body);

/// The principal axis of the least moment (the direction of a rod), in world axes. Precondition: the body is movable.
[[nodiscard]] Vector3<double> long_axis(const Body& body);

/// Moves the centre of mass so that P − X is r, up to the rounding of X.
void set_lever_arm(Collision& collision, Body& body, const Vector3<double>& r);

/// Moves the centre of mass so that P − X is exactly r. If P has too many bits, first rounds P or moves P to the
/// origin.
void set_exact_lever_arm(Collision& collision, Body& body, const Vector3<double>& r);

[[nodiscard]] bool is_exact_lever_arm(const Collision& collision, const Body& body);

/// Moves the contact to the origin, and the bodies with it. Each lever arm becomes exactly its rounded value.
void move_point_to_origin(Collision& collision);

/// Turns the spin along the lever arm, unless one of them is zero.
void spin_along_lever_arm(const Collision& collision, Body& body);

[[nodiscard]] inline bool are_movable(const Collision& collision) {
  return !collision.a.immovable && !collision.b.immovable;
}

/// Replaces an immovable body by a movable one, about as large as its lever arm is long.
void make_movable(Stream& stream, const Collision& collision, Body& body);
void make_both_movable(Stream& stream, Collision& collision);

}  // namespace carom::properties::features
