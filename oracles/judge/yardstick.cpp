// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/judge/yardstick.hpp>

namespace carom::oracles {

PerVector<double> permitted_noise(const Collision& collision, const Yardstick& yardstick) {
  PerVector<double> noise{};
  if (!yardstick.digits()) {
    return noise;
  }
  const auto radius = [](const Body& body) {
    return body.immovable ? 0 : std::sqrt(body.principal_inertia.minCoeff() / body.mass);
  };
  double speed = 0;
  for (const Body* body : {&collision.a, &collision.b}) {
    const double reach = std::max(norm_of(Vector3<double>(collision.point - body->position)), radius(*body));
    speed = std::max({speed, norm_of(body->velocity), norm_of(body->angular_velocity) * reach});
  }
  const double size = yardstick.rounding() * speed;
  const auto set = [&](const Body& body, OutcomeVector velocity, OutcomeVector spin) {
    noise[velocity] = size;
    noise[spin] = body.immovable ? 0 : size / radius(body);
  };
  set(collision.a, OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a);
  set(collision.b, OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b);
  return noise;
}

void add_permitted_noise(const Collision& collision, const Yardstick& yardstick, PerVector<double>& sizes) {
  if (!yardstick.digits()) {
    return;  // an exact judge has no noise, and the allowance 0
  }
  const PerVector<double> noise = permitted_noise(collision, yardstick);
  for (const OutcomeVector k : all_outcome_vectors) {
    sizes[k] += noise[k] / yardstick.allowance();
  }
}

}  // namespace carom::oracles
