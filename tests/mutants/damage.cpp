// SPDX-License-Identifier: BSL-1.0
#include "damage.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <carom/impulse/laws.hpp>

namespace carom::mutants {
namespace {

using Vector = Vector3<double>;
using ContactImpulse = impulse::ContactImpulse<double>;

/// A vector of the same length, orthogonal to `vector`.
Vector across(const Vector& vector) {
  int least = 0;
  vector.cwiseAbs().minCoeff(&least);
  return vector.cross(Vector::Unit(least)).normalized() * vector.norm();
}

/// The outcome of `impulse` on A and −`impulse` on B.
Outcome<double> struck_by(const Solution& sound, const Vector& impulse) {
  return impulse::apply_impulse(sound.contact,
                                impulse::contact_impulse(sound.contact, sound.impulse.colliding, impulse));
}

/// Computes the law's impulse for `other`, with N·V⁻ of the sound contact, and applies it to the sound contact.
Outcome<double> solved_as(const Solution& sound, const impulse::Contact<double>& other) {
  Outcome<double> outcome;
  impulse::with_law(sound.law, [&](const auto& solver) {
    const auto result = solver(other, impulse::normal_velocity(sound.contact));
    const ContactImpulse& acting = acting_impulse(result);
    outcome =
        impulse::apply_impulse(sound.contact, impulse::contact_impulse(sound.contact, acting.colliding, acting.on_a));
  });
  return outcome;
}

void change_reversed(Vector& after, const Vector& before, int component) {
  after[component] = before[component] - (after[component] - before[component]);
}

Vector across_normal(const Vector& vector, const Vector& normal) {
  return vector - normal * (normal.dot(vector) / normal.squaredNorm());
}

}  // namespace

std::string_view name_of(Damage damage) {
  switch (damage) {
    case Damage::torque_of_a_dropped:
      return "torque_of_a_dropped";
    case Damage::turning_left_out_of_k:
      return "turning_left_out_of_k";
    case Damage::restitution_ignored:
      return "restitution_ignored";
    case Damage::nothing_happens:
      return "nothing_happens";
    case Damage::reaction_dropped:
      return "reaction_dropped";
    case Damage::sign_of_impulse_component:
      return "sign_of_impulse_component";
    case Damage::sign_of_torque_component:
      return "sign_of_torque_component";
    case Damage::component_in_binary32:
      return "component_in_binary32";
    case Damage::impulse_off:
      return "impulse_off";
    case Damage::impulse_turned:
      return "impulse_turned";
    case Damage::spin_along_normal_lost:
      return "spin_along_normal_lost";
    case Damage::bodies_exchanged:
      return "bodies_exchanged";
    case Damage::last_answer_again:
      return "last_answer_again";
    case Damage::not_a_number:
      break;
  }
  return "not_a_number";
}

std::string_view sentence_of(Damage damage) {
  switch (damage) {
    case Damage::torque_of_a_dropped:
      return "A keeps its spin";
    case Damage::turning_left_out_of_k:
      return "the impulse is that of bodies that cannot turn";
    case Damage::restitution_ignored:
      return "ε is taken for 0";
    case Damage::nothing_happens:
      return "the velocities before the impulse are returned";
    case Damage::reaction_dropped:
      return "B is not struck";
    case Damage::sign_of_impulse_component:
      return "the x component of the velocity of A is changed with the wrong sign";
    case Damage::sign_of_torque_component:
      return "the z component of the spin of B is changed with the wrong sign";
    case Damage::component_in_binary32:
      return "the y component of the velocity of B is rounded to binary32";
    case Damage::impulse_off:
      return "F is too large by 10⁻⁹ of itself";
    case Damage::impulse_turned:
      return "F is turned by 10⁻⁶";
    case Damage::spin_along_normal_lost:
      return "both spins lose their parts along N";
    case Damage::bodies_exchanged:
      return "the velocities of A are answered for B, and those of B for A";
    case Damage::last_answer_again:
      return "the answer to the collision before is returned";
    case Damage::not_a_number:
      break;
  }
  return "the z component of the spin of A is NaN";
}

Solution solved(Law law, const Collision& collision) {
  Solution solution{law, impulse::make_contact<double>(collision), {}, {}};
  impulse::with_law(law, [&](const auto& solver) {
    const auto impulse = solver(solution.contact);
    solution.impulse = acting_impulse(impulse);
    solution.outcome = impulse::apply_impulse(solution.contact, impulse);
  });
  return solution;
}

Outcome<double> damaged(Damage damage, const Solution& sound, const Outcome<double>& last) {
  const Vector& impulse = sound.impulse.on_a;
  Outcome<double> outcome = sound.outcome;
  switch (damage) {
    case Damage::torque_of_a_dropped:
      outcome.a.angular_velocity = sound.contact.a.angular_velocity;
      break;
    case Damage::turning_left_out_of_k: {
      impulse::Contact<double> without_arms = sound.contact;
      for (auto* body : {&without_arms.a, &without_arms.b}) {
        body->velocity += body->angular_velocity.cross(body->lever_arm);
        body->lever_arm.setZero();
      }
      return solved_as(sound, without_arms);
    }
    case Damage::restitution_ignored: {
      impulse::Contact<double> inelastic = sound.contact;
      inelastic.restitution = 0;
      return solved_as(sound, inelastic);
    }
    case Damage::nothing_happens:
      return impulse::unchanged(sound.contact);
    case Damage::reaction_dropped:
      outcome.b = impulse::unchanged(sound.contact.b);
      break;
    case Damage::sign_of_impulse_component:
      change_reversed(outcome.a.velocity, sound.contact.a.velocity, 0);
      break;
    case Damage::sign_of_torque_component:
      change_reversed(outcome.b.angular_velocity, sound.contact.b.angular_velocity, 2);
      break;
    case Damage::component_in_binary32:
      outcome.b.velocity[1] = static_cast<double>(static_cast<float>(outcome.b.velocity[1]));
      break;
    case Damage::impulse_off: {
      constexpr double off = 1e-9;
      return struck_by(sound, impulse * (1 + off));
    }
    case Damage::impulse_turned: {
      constexpr double angle = 1e-6;  // [rad]
      return struck_by(sound, impulse + across(impulse) * angle);
    }
    case Damage::spin_along_normal_lost:
      for (auto* body : {&outcome.a, &outcome.b}) {
        body->angular_velocity = across_normal(body->angular_velocity, sound.contact.normal);
      }
      break;
    case Damage::bodies_exchanged:
      std::swap(outcome.a, outcome.b);
      break;
    case Damage::last_answer_again:
      return last;
    case Damage::not_a_number:
      outcome.a.angular_velocity[2] = std::numeric_limits<double>::quiet_NaN();
      break;
  }
  return outcome;
}

bool differ(const Outcome<double>& x, const Outcome<double>& y) {
  const auto of_x = vectors(x);
  const auto of_y = vectors(y);
  for (const OutcomeVector k : all_outcome_vectors) {
    if ((of_x[k]->array() != of_y[k]->array()).any()) {
      return true;
    }
  }
  return false;
}

}  // namespace carom::mutants
