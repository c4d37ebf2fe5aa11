// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/oracles/judge/second_order.hpp>
#include <carom/oracles/laws/kinematics.hpp>

namespace carom::oracles {
namespace {

/// Beyond the range of numbers, a part of second order is left out.
void drop_infinite(Sensitivity& scale) {
  for (const OutcomeVector k : all_outcome_vectors) {
    scale[k] = std::isfinite(scale[k]) ? scale[k] : 0;
  }
}

/// ‖J⁻¹ (I − f fᵀ)‖_F for the unit vector f: the largest spin that a torque of length 1 across f may cause.
double response_across(const Body& body, const Vector3<double>& f) {
  const Vector3<double> in_body = turned<double>(conjugate(body.orientation), f);
  return root_of_squares(3, [&](std::size_t i) {
    const double y = in_body[static_cast<Eigen::Index>((i + 1) % 3)];
    const double z = in_body[static_cast<Eigen::Index>((i + 2) % 3)];
    return std::sqrt(y * y + z * z) / body.principal_inertia[static_cast<Eigen::Index>(i)];
  });
}

/// Adds the changes of the velocities if K changes by at most `change_of(body)` ‖J⁻¹ (I − f fᵀ)‖ for each movable body,
/// with f along the impulse F. F then changes by at most the sum of these changes times ‖F‖ / λ, because K ⪰ λI.
template <class ChangeOf>
void add_change_of_matrix(const Collision& c, const Vector3<double>& impulse, const ChangeOf& change_of,
                          Sensitivity& scale) {
  const double length = norm_of(impulse);
  if (length == 0) {
    return;
  }
  double sum = 0;
  for (const Body* body : {&c.a, &c.b}) {
    sum += body->immovable ? 0 : change_of(*body) * response_across(*body, impulse / length);
  }
  const double change = sum / inverse_mass(c) * length;
  const auto add_body = [&](const Body& body, OutcomeVector velocity, OutcomeVector spin) {
    if (!body.immovable) {
      scale[velocity] += change / body.mass;
      scale[spin] += change * norm_of(lever_arm(body, c.point)) / body.principal_inertia.minCoeff();
    }
  };
  add_body(c.a, OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a);
  add_body(c.b, OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b);
}

}  // namespace

Sensitivity second_order(const Collision& c) {
  double speed = 0;
  double lambda = 0;
  for (const Body* body : {&c.a, &c.b}) {
    speed += norm_of(body->velocity) + norm_of(body->angular_velocity) * length_of_lever_arm(*body, c.point);
    lambda += body->immovable ? 0 : 1 / body->mass;
  }
  const double impulse = 2 * speed / lambda;  // not used if both bodies are immovable
  const auto of_velocity = [&](const Body& body) {
    return norm_of(body.velocity) + (body.immovable ? 0 : impulse / body.mass);
  };
  const auto of_spin = [&](const Body& body) {
    return norm_of(body.angular_velocity) +
           (body.immovable ? 0 : impulse * length_of_lever_arm(body, c.point) / body.principal_inertia.minCoeff());
  };
  Sensitivity scale{};
  scale[OutcomeVector::velocity_of_a] = of_velocity(c.a);
  scale[OutcomeVector::angular_velocity_of_a] = of_spin(c.a);
  scale[OutcomeVector::velocity_of_b] = of_velocity(c.b);
  scale[OutcomeVector::angular_velocity_of_b] = of_spin(c.b);
  drop_infinite(scale);
  return scale;
}

Sensitivity second_order_of_arms(const Collision& c, std::initializer_list<Vector3<double>> impulses) {
  const auto squared = [&](const Body& body) {
    return length_of_lever_arm(body, c.point) * length_of_lever_arm(body, c.point);
  };
  Sensitivity scale{};
  for (const Vector3<double>& impulse : impulses) {
    add_change_of_matrix(c, impulse, squared, scale);
  }
  drop_infinite(scale);
  return scale;
}

Sensitivity second_order_from_rest(const Collision& c, double normal_velocity_sensitivity) {
  const double normal = norm_of(c.normal);
  // |N·V⁻| and its rounding are at most the allowance times the sensitivity each, and λ ‖F‖ ≤ (1 + ε) |N·V⁻| / ‖N‖.
  const double impulse = (1 + c.restitution) * 2 * normal_velocity_sensitivity / (normal * inverse_mass(c));
  const auto crossed = [&](const Body& body) {
    return 2 * length_of_lever_arm(body, c.point) * norm_of(lever_arm(body, c.point));
  };
  Sensitivity scale{};
  add_change_of_matrix(c, c.normal * (impulse / normal), crossed, scale);
  drop_infinite(scale);
  return scale;
}

}  // namespace carom::oracles
