// SPDX-License-Identifier: BSL-1.0
#include "leaves_truth.hpp"

#include <cmath>

#include <carom/properties/features/geometry.hpp>

namespace carom::mutants {
namespace {

template <class T>
bool are_equal(const Vector3<T>& x, const Vector3<T>& y) {
  return x[0] == y[0] && x[1] == y[1] && x[2] == y[2];
}

template <class T>
bool is_orthogonal(const Vector3<T>& x, const Vector3<T>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] == 0;
}

template <class T>
bool is_binary32(const T& number) {
  const auto rounded = static_cast<float>(oracles::nearest_double(number));
  return std::isfinite(rounded) && T(static_cast<double>(rounded)) == number;
}

template <class T>
bool leaves(Damage damage, const BasicCollision<T>& c, const oracles::Truth<T>& exact, Law law) {
  const Outcome<T>& truth = exact.outcome;
  const auto keeps_spin = [&](auto body, auto of_outcome) {
    return (c.*body).immovable || are_equal<T>((truth.*of_outcome).angular_velocity, (c.*body).angular_velocity);
  };
  const bool a_keeps_spin = keeps_spin(&BasicCollision<T>::a, &Outcome<T>::a);
  const bool b_keeps_spin = keeps_spin(&BasicCollision<T>::b, &Outcome<T>::b);
  const auto is_at_centre = [&](const BasicBody<T>& body) {
    return body.immovable || are_equal<T>(body.position, c.point);
  };
  switch (damage) {
    case Damage::torque_of_a_dropped:
      return a_keeps_spin;
    case Damage::turning_left_out_of_k:
      // The damage puts λI in place of K, with λ = 1/m_A + 1/m_B. F·(K − λI) F = Σ (r × F)·J⁻¹(r × F) over the bodies,
      // so K F = λF if and only if F turns neither body. The F of `rough` is a sum of two impulses, and neither may
      // turn a body.
      return a_keeps_spin && b_keeps_spin &&
             (law != Law::rough || are_equal<T>(c.normal.cross(exact.impulse), Vector3<T>{T(0), T(0), T(0)}) ||
              (is_at_centre(c.a) && is_at_centre(c.b)));
    case Damage::restitution_ignored:
      return c.restitution == 0;
    case Damage::reaction_dropped:
      return c.b.immovable;
    case Damage::sign_of_impulse_component:
      return c.a.immovable || truth.a.velocity[0] == c.a.velocity[0];
    case Damage::sign_of_torque_component:
      return c.b.immovable || truth.b.angular_velocity[2] == c.b.angular_velocity[2];
    case Damage::component_in_binary32:
      return is_binary32(truth.b.velocity[1]);
    case Damage::spin_along_normal_lost:
      return is_orthogonal<T>(truth.a.angular_velocity, c.normal) &&
             is_orthogonal<T>(truth.b.angular_velocity, c.normal);
    case Damage::bodies_exchanged:
      return are_equal<T>(truth.a.velocity, truth.b.velocity) &&
             are_equal<T>(truth.a.angular_velocity, truth.b.angular_velocity);
    case Damage::nothing_happens:  // never harmless: N·V⁻ < 0 ≤ N·V⁺, so F ≠ 0
    case Damage::impulse_off:
    case Damage::impulse_turned:
    case Damage::last_answer_again:
    case Damage::not_a_number:
      break;
  }
  return false;
}

}  // namespace

Collision as_read(const Collision& collision) {
  Collision read = collision;
  properties::features::move_point_to_origin(read);
  return read;
}

bool leaves_truth(Damage damage, const oracles::ExactCase& read, Law law) {
  return read.with_truth(law, oracles::Approach::colliding, [&]<class T>(const oracles::Truth<T>& truth) {
    return leaves<T>(damage, map_numbers<T>(read.collision(), [](double number) { return T(number); }), truth, law);
  });
}

}  // namespace carom::mutants
