// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/stream.hpp>
#include <carom/properties/draws/vectors.hpp>

/// Geometry in binary64, for predicates and for what makes them true.
namespace carom::properties::features {

/// The domain of masses [kg].
inline constexpr double least_mass = 1e-9;
inline constexpr double largest_mass = 1e10;

/// P − X as rounded.
[[nodiscard]] inline Vector3<double> lever_arm(const Collision& collision, const Body& body) {
  return collision.point - body.position;
}

[[nodiscard]] inline bool is_zero(const Vector3<double>& v) { return (v.array() == 0).all(); }

/// Of vectors that are not zero: one is a multiple of the other, exactly.
[[nodiscard]] bool are_parallel(const Vector3<double>& u, const Vector3<double>& v);

/// Of vectors that are not zero.
[[nodiscard]] inline bool are_orthogonal(const Vector3<double>& u, const Vector3<double>& v) {
  return !is_zero(u) && !is_zero(v) && dot(u, v) == 0;
}

[[nodiscard]] inline int nonzero_components(const Vector3<double>& v) {
  return static_cast<int>((v.array() != 0).count());
}

/// Two components are equal but for the sign, and not zero.
[[nodiscard]] bool has_ties(const Vector3<double>& v);

/// Each component rounded to eight bits, so that sums and products with others of that kind are exact.
[[nodiscard]] Vector3<double> with_few_bits(const Vector3<double>& v);

/// A power of two near the length of v; 1 where that is zero.
[[nodiscard]] double size_of(const Vector3<double>& v);

/// v turned into this direction at about its length, exactly a multiple of it.
[[nodiscard]] Vector3<double> turned_along(const Vector3<double>& v, const Vector3<double>& direction);

/// A vector of about the length of v, exactly orthogonal to a direction of few bits.
[[nodiscard]] Vector3<double> turned_across(Stream& stream, const Vector3<double>& v, const Vector3<double>& direction);

/// √((I₁ + I₂ + I₃) / 2m), how far from the centre of mass the mass is; 0 of an immovable body.
[[nodiscard]] double radius_of_gyration(const Body& body);

/// By how many times the contact lies farther from a body axis e than twice the radius of gyration about it: the
/// greatest |e × r| / 2√(I/m); 0 of an immovable body. Far beyond 1 K has no bound.
[[nodiscard]] double overreach(const Collision& collision, const Body& body);

/// The body axis about which the moment is least, in world coordinates: along a rod. Precondition: the body is movable.
[[nodiscard]] Vector3<double> long_axis(const Body& body);

/// Moves the centre of mass so that P − X is r, up to rounding of its place.
void set_lever_arm(Collision& collision, Body& body, const Vector3<double>& r);

/// Moves the centre of mass so that P − X is r, exactly: where P is in the way, it is first rounded to few bits, or put
/// at the origin.
void set_exact_lever_arm(Collision& collision, Body& body, const Vector3<double>& r);

/// Whether P − X needs no rounding.
[[nodiscard]] bool is_exact_lever_arm(const Collision& collision, const Body& body);

/// Moves both bodies with the contact, the lever arms becoming what they were as rounded.
void move_point_to_origin(Collision& collision);

/// A movable body in place of an immovable one, as large as its lever arm is long; others stay as they are.
void make_movable(Stream& stream, const Collision& collision, Body& body);

}  // namespace carom::properties::features
