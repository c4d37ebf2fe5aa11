// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>

namespace carom::properties {

Vector3<double> relative_velocity(const Collision& collision) {
  const auto of_contact_point = [&](const Body& body) {
    const Vector3<double> lever_arm = collision.point - body.position;
    return Vector3<double>(body.velocity + cross(body.angular_velocity, lever_arm));
  };
  return of_contact_point(collision.a) - of_contact_point(collision.b);
}

void set_relative_velocity(Collision& collision, const Vector3<double>& wanted) {
  const Vector3<double> change = wanted - relative_velocity(collision);
  if (collision.a.immovable) {
    collision.b.velocity -= change;
  } else {
    collision.a.velocity += change;
  }
}

void make_approaching(Collision& collision) {
  if (dot(collision.normal, relative_velocity(collision)) > 0) {
    collision.normal = negated(collision.normal);
  }
}

bool is_approaching(const Collision& collision) { return dot(collision.normal, relative_velocity(collision)) < 0; }

bool reverse_if_separating(Collision& collision) {
  if (dot(collision.normal, relative_velocity(collision)) <= 0) {
    return false;
  }
  for (Body* body : {&collision.a, &collision.b}) {
    body->velocity = negated(body->velocity);
    body->angular_velocity = negated(body->angular_velocity);
  }
  return true;
}

void make_immovable(Body& body) {
  Body fixed;
  fixed.immovable = true;
  fixed.position = body.position;
  body = fixed;
}

}  // namespace carom::properties
