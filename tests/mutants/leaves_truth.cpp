// SPDX-License-Identifier: GPL-3.0-or-later
#include "leaves_truth.hpp"

#include <cmath>

#include <carom/properties/features/places.hpp>

namespace carom::mutants {
namespace {

using oracles::Rational;
using ExactVector = Vector3<Rational>;

bool are_equal(const ExactVector& x, const ExactVector& y) { return x[0] == y[0] && x[1] == y[1] && x[2] == y[2]; }

bool is_orthogonal(const ExactVector& x, const ExactVector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] == 0; }

bool is_binary32(const Rational& number) {
  const auto rounded = static_cast<float>(oracles::nearest_double(number));
  return std::isfinite(rounded) && Rational(static_cast<double>(rounded)) == number;
}

}  // namespace

Collision as_read(const Collision& collision) {
  Collision read = collision;
  properties::features::move_point_to_origin(read);
  return read;
}

bool leaves_truth(Damage damage, const oracles::ExactCase& read, Model model) {
  const BasicCollision<Rational>& c = read.exact();
  const auto truth = [&]() -> const Outcome<Rational>& {
    return read.truth(model, oracles::Approach::colliding).outcome;
  };
  const auto keeps_spin = [&](auto body, auto of_outcome) {
    return (c.*body).immovable || are_equal((truth().*of_outcome).angular_velocity, (c.*body).angular_velocity);
  };
  const auto a_keeps_spin = [&] { return keeps_spin(&BasicCollision<Rational>::a, &Outcome<Rational>::a); };
  const auto b_keeps_spin = [&] { return keeps_spin(&BasicCollision<Rational>::b, &Outcome<Rational>::b); };
  switch (damage) {
    case Damage::torque_of_a_dropped:
      return a_keeps_spin();
    case Damage::turning_left_out_of_k:
      // K − λI is a sum of squares, so K F = λF just where neither body is turned.
      return a_keeps_spin() && b_keeps_spin();
    case Damage::restitution_ignored:
      return c.restitution == 0;
    case Damage::reaction_dropped:
      return c.b.immovable;
    case Damage::sign_of_impulse_component:
      return c.a.immovable || truth().a.velocity[0] == c.a.velocity[0];
    case Damage::sign_of_torque_component:
      return c.b.immovable || truth().b.angular_velocity[2] == c.b.angular_velocity[2];
    case Damage::component_in_binary32:
      return is_binary32(truth().b.velocity[1]);
    case Damage::spin_along_normal_lost:
      return is_orthogonal(truth().a.angular_velocity, c.normal) && is_orthogonal(truth().b.angular_velocity, c.normal);
    case Damage::bodies_exchanged:
      return are_equal(truth().a.velocity, truth().b.velocity) &&
             are_equal(truth().a.angular_velocity, truth().b.angular_velocity);
    case Damage::nothing_happens:  // F ≠ 0, since N·V changes its sign
    case Damage::impulse_off:
    case Damage::impulse_turned:
    case Damage::last_answer_again:
    case Damage::not_a_number:
      break;
  }
  return false;
}

}  // namespace carom::mutants
