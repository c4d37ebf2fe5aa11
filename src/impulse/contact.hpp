// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <type_traits>

#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/collision/validate.hpp>
#include <carom/impulse/numbers/products.hpp>
#include <carom/impulse/principal_inertia.hpp>

/// The input of the solvers. "The note" is D. Eberly, "Computing Impulse Forces for Colliding Contact"
/// (docs/findings/note.md).
namespace carom::impulse {

/// The input of a solver for one body, in world coordinates. Inertia is the representation of J⁻¹: `PrincipalInertia`
/// or `WorldInertia`.
template <class S, class Inertia = PrincipalInertia<S>>
struct ContactBody {
  S inverse_mass;               // 0 if immovable [1/kg]
  Inertia inertia;              // about the centre of mass
  Vector3<S> lever_arm;         // r, from the centre of mass to the contact point [m]
  Vector3<S> velocity;          // of the centre of mass, before the impulse [m/s]
  Vector3<S> angular_velocity;  // before the impulse [rad/s]
};

/// The input of a solver, in its own scalar type.
template <class S, class Inertia = PrincipalInertia<S>>
struct Contact {
  ContactBody<S, Inertia> a;
  ContactBody<S, Inertia> b;
  Vector3<S> normal;         // N, on body B, pointing from B to A; any nonzero length
  S restitution;             // ε in [0, 1]
  S friction;                // μ ≥ 0; only the laws `rough` and `coulomb` read it
  S tangential_restitution;  // e_t in [-1, 1]; only the law `rough` reads it
};

/// The vector in S, scaled by a power of two so that its largest component has a size in [1/2, 1). Products of two such
/// vectors stay in the range of S. Only a vector of a built-in floating-point type is scaled.
template <class S, class Vector>
[[nodiscard]] auto without_extreme_length(const Vector& vector) {
  using From = typename Vector::Scalar;
  Eigen::Matrix<S, Vector::RowsAtCompileTime, 1> scaled;
  if constexpr (std::is_floating_point_v<From>) {
    int exponent = 0;
    std::frexp(vector.cwiseAbs().maxCoeff(), &exponent);
    // A product with a power of two has the bits of ldexp. The power overflows if the vector is subnormal.
    const From power = std::ldexp(From(1), -exponent);
    const bool is_power_finite = std::isfinite(power);
    for (int i = 0; i < vector.size(); ++i) {
      scaled[i] = static_cast<S>(is_power_finite ? vector[i] * power : std::ldexp(vector[i], -exponent));
    }
  } else {
    for (int i = 0; i < vector.size(); ++i) {
      scaled[i] = static_cast<S>(vector[i]);
    }
  }
  return scaled;
}

/// The body as input of a solver in S. Precondition: the collision is valid.
template <class S, class Inertia = PrincipalInertia<S>, class T>
[[nodiscard]] ContactBody<S, Inertia> make_contact_body(const BasicBody<T>& body, const Vector3<T>& point) {
  const auto in_s = [](const Vector3<T>& vector) {
    return Vector3<S>{static_cast<S>(vector[0]), static_cast<S>(vector[1]), static_cast<S>(vector[2])};
  };
  ContactBody<S, Inertia> result{S(0), Inertia::immovable(), in_s(point) - in_s(body.position), in_s(body.velocity),
                                 in_s(body.angular_velocity)};
  if (!body.immovable) {
    result.inverse_mass = S(1) / static_cast<S>(body.mass);
    result.inertia = Inertia::of(in_s(body.principal_inertia), without_extreme_length<S>(body.orientation));
  }
  return result;
}

/// The contact of a collision. Every number is first rounded to S. Precondition: `validate` finds no defect.
template <class S, class Inertia = PrincipalInertia<S>, class T>
[[nodiscard]] Contact<S, Inertia> make_contact(const BasicCollision<T>& collision) {
  if constexpr (std::is_same_v<T, double>) {
    CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  }
  return {make_contact_body<S, Inertia>(collision.a, collision.point),
          make_contact_body<S, Inertia>(collision.b, collision.point),
          without_extreme_length<S>(collision.normal),
          static_cast<S>(collision.restitution),
          static_cast<S>(collision.friction),
          static_cast<S>(collision.tangential_restitution)};
}

/// Whether the contact can have been made from a valid collision: a bool, or a mask if S is a SIMD pack. Lever arms and
/// velocities are not checked, because they may overflow in S.
template <class S, class Inertia>
[[nodiscard]] auto is_made_of_valid(const Contact<S, Inertia>& contact) {
  return !(contact.a.inverse_mass < S(0)) && !(contact.b.inverse_mass < S(0)) &&
         dot(contact.normal, contact.normal) > S(0) && !(contact.restitution < S(0)) && !(S(1) < contact.restitution) &&
         !(contact.friction < S(0)) && !(contact.tangential_restitution < S(-1)) &&
         !(S(1) < contact.tangential_restitution);
}

/// V = V_A − V_B, the relative velocity of the material points at the contact (the note's equation 3).
template <class S, class Inertia>
[[nodiscard]] Vector3<S> relative_velocity(const Contact<S, Inertia>& contact) {
  const Vector3<S> velocity_a = contact.a.velocity + cross(contact.a.angular_velocity, contact.a.lever_arm);
  const Vector3<S> velocity_b = contact.b.velocity + cross(contact.b.angular_velocity, contact.b.lever_arm);
  return velocity_a - velocity_b;
}

/// N·V, and the vectors r × N of both bodies.
template <class S>
struct Approach {
  S normal_velocity;
  Vector3<S> torque_arm_a;
  Vector3<S> torque_arm_b;
};

/// The approach with a known N·V.
template <class S, class Inertia>
[[nodiscard]] Approach<S> approach_of(const Contact<S, Inertia>& contact, const S& normal_velocity) {
  return {normal_velocity, cross(contact.a.lever_arm, contact.normal), cross(contact.b.lever_arm, contact.normal)};
}

/// The part of N·V by the spins. An angular velocity w contributes w·(r × N), which is exactly 0 if the lever arm r
/// lies along N. The equal N·(w × r) would keep the rounding error of w × r.
template <class S, class Inertia>
[[nodiscard]] S normal_velocity_by_spins(const Contact<S, Inertia>& contact, const Approach<S>& approach) {
  return dot(contact.a.angular_velocity, approach.torque_arm_a) -
         dot(contact.b.angular_velocity, approach.torque_arm_b);
}

template <class S, class Inertia>
[[nodiscard]] Approach<S> approach_of(const Contact<S, Inertia>& contact) {
  Approach<S> approach = approach_of(contact, S(0));
  approach.normal_velocity =
      dot(contact.normal, contact.a.velocity - contact.b.velocity) + normal_velocity_by_spins(contact, approach);
  return approach;
}

/// N·V.
template <class S, class Inertia>
[[nodiscard]] S normal_velocity(const Contact<S, Inertia>& contact) {
  return approach_of(contact).normal_velocity;
}

/// λ = 1/m_A + 1/m_B, a lower bound of the eigenvalues of the collision matrix K (collision_matrix.hpp).
template <class S, class Inertia>
[[nodiscard]] S inverse_mass(const Contact<S, Inertia>& contact) {
  return contact.a.inverse_mass + contact.b.inverse_mass;
}

/// Whether an impulse acts: the bodies approach along the normal, and at least one body can move. A bool, or a mask if
/// S is a pack.
template <class S, class Inertia>
[[nodiscard]] auto is_colliding(const Contact<S, Inertia>& contact, const S& normal_velocity) {
  return normal_velocity < S(0) && inverse_mass(contact) > S(0);
}

/// The unchanged velocities: the outcome of a contact that is not colliding.
template <class S, class Inertia>
[[nodiscard]] BodyVelocity<S> unchanged(const ContactBody<S, Inertia>& body) {
  return {body.velocity, body.angular_velocity};
}
template <class S, class Inertia>
[[nodiscard]] Outcome<S> unchanged(const Contact<S, Inertia>& contact) {
  return {unchanged(contact.a), unchanged(contact.b)};
}

/// Whether a body of the contact is slender (`is_slender` of its inertia): a bool, or a mask if S is a pack.
template <class S, class Inertia>
[[nodiscard]] auto has_slender(const Contact<S, Inertia>& contact) {
  return is_slender(contact.a.inertia) || is_slender(contact.b.inertia);
}

/// The velocities of a body after `impulse` [N s] acts on it and changes its spin by `change_of_spin` (the note's
/// equation 23).
template <class S, class Inertia>
[[nodiscard]] BodyVelocity<S> struck(const ContactBody<S, Inertia>& body, const Vector3<S>& impulse,
                                     const Vector3<S>& change_of_spin) {
  return {body.velocity + impulse * body.inverse_mass, body.angular_velocity + change_of_spin};
}

template <class S, class Inertia, class Condition>
[[nodiscard]] BodyVelocity<S> apply_impulse(const ContactBody<S, Inertia>& body, const Vector3<S>& impulse,
                                            const Condition& has_slender) {
  return struck(body, impulse, angular_response(body.inertia, body.lever_arm, impulse, has_slender));
}

/// The outcome of the impulse F = `impulse` [N s] on A and −F on B.
template <class S, class Inertia>
[[nodiscard]] Outcome<S> apply_impulse(const Contact<S, Inertia>& contact, const Vector3<S>& impulse) {
  const auto is_any_slender = has_slender(contact);
  return {apply_impulse(contact.a, impulse, is_any_slender),
          apply_impulse<S, Inertia>(contact.b, -impulse, is_any_slender)};
}

}  // namespace carom::impulse
