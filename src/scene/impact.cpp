// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>

#include <carom/collision/expects.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/impulse/numbers/exact_sum.hpp>
#include <carom/impulse/rough.hpp>
#include <carom/impulse/solve3.hpp>
#include <carom/impulse/sticking.hpp>
#include <carom/scene/crossing.hpp>
#include <carom/scene/impact.hpp>

namespace carom::scene {
namespace {

Body body_of(const StruckSphere& sphere, const Vector3<double>& from_contact) {
  Body body;
  body.mass = sphere.mass;
  body.principal_inertia = Vector3<double>::Constant(sphere.moment);
  body.position = from_contact;
  body.velocity = sphere.velocity;
  body.angular_velocity = sphere.angular_velocity;
  return body;
}

void set_material(Collision& collision, const MaterialPair& pair) {
  collision.restitution = pair.restitution;
  collision.friction = pair.friction;
  collision.tangential_restitution = pair.tangential_restitution;
}

template <class S>
BodyVelocity<double> in_double(const BodyVelocity<S>& velocity) {
  const auto rounded = [](const Vector3<S>& v) {
    return Vector3<double>{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
  };
  return {rounded(velocity.velocity), rounded(velocity.angular_velocity)};
}

template <class S>
Outcome<double> struck_in(Law law, const Collision& collision) {
  using impulse::Ldlt;
  using Inertia = impulse::PrincipalInertia<S, impulse::Moments::equal>;
  impulse::Contact<S, Inertia> contact = impulse::make_contact<S, Inertia>(collision);
  const auto outcome = [&]() -> Outcome<S> {
    switch (law) {
      case Law::frictionless:
      case Law::reflection:
        // The lever arms lie along the normal, so they do not change the impulse. Zero lever arms keep the spins
        // exactly.
        contact.a.lever_arm.setConstant(S(0));
        contact.b.lever_arm.setConstant(S(0));
        return impulse::frictionless<S, Inertia>(contact);
      case Law::sticking:
        return impulse::sticking<Ldlt, S, Inertia>(contact);
      case Law::coulomb:
        contact.tangential_restitution = S(0);
        break;
      case Law::rough:
      case Law::any:
        break;
    }
    return impulse::rough<Ldlt, S, Inertia>(contact);
  }();
  Outcome<double> result{in_double(outcome.a), in_double(outcome.b)};
  // Rounding to S would change velocities that the impulse does not affect.
  if (law == Law::frictionless || law == Law::reflection) {
    result.a.angular_velocity = collision.a.angular_velocity;
    result.b.angular_velocity = collision.b.angular_velocity;
  }
  if (collision.b.immovable) {
    result.b = {collision.b.velocity, collision.b.angular_velocity};
  }
  return result;
}

/// Changes one component of v, along the axis of N's greatest component. The change cancels `approach` = N·v < 0, and
/// is one ulp larger.
void add_along(const Vector3<double>& normal, double approach, Vector3<double>& velocity) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const double enough = velocity[axis] - approach / normal[axis];
  velocity[axis] = std::nextafter(enough, std::copysign(never, normal[axis]));
}

/// N·v, in double if its sign is certain, otherwise from the exact sum.
template <class Exactly>
double approach_of(const Vector3<double>& normal, const Vector3<double>& velocity, const Exactly& exactly) {
  const double sum = normal.dot(velocity);
  return std::abs(sum) > 8 * roundoff * normal.cwiseAbs().dot(velocity.cwiseAbs()) ? sum : exactly().approximately();
}

}  // namespace

Collision collision_of(const StruckSphere& a, const StruckSphere& b, const MaterialPair& pair) {
  Collision collision;
  const Vector3<double> unit = (a.position - b.position).normalized();
  collision.a = body_of(a, a.radius * unit);
  // The normal is the lever arm of A itself, so rounding cannot make their directions differ.
  collision.normal = collision.a.position;
  collision.b = body_of(b, -b.radius * unit);
  set_material(collision, pair);
  return collision;
}

Collision collision_with_plane(const StruckSphere& a, const Vector3<double>& normal, const MaterialPair& pair) {
  Collision collision;
  collision.a = body_of(a, normal * (a.radius / normal.norm()));
  collision.normal = collision.a.position;
  collision.b.immovable = true;
  set_material(collision, pair);
  return collision;
}

Outcome<double> struck(Law law, Precision precision, const Collision& collision) {
  CAROM_EXPECTS(law != Law::any);
  CAROM_EXPECTS(collision.normal == collision.a.position, collision.normal, collision.a.position);
  switch (precision) {
    case Precision::binary32:
      return struck_in<float>(law, collision);
    case Precision::binary64:
      return struck_in<double>(law, collision);
    case Precision::extended:
      break;
  }
  return struck_in<impulse::DoubleDouble>(law, collision);
}

void keep_apart(const Vector3<double>& position_a, const Vector3<double>& position_b, Vector3<double>& velocity_a,
                const Vector3<double>& velocity_b) {
  const Vector3<double> normal = position_a - position_b;
  const auto approach = [&] {
    return approach_of(normal, velocity_a - velocity_b, [&] {
      impulse::ExactSum sum;
      for (int k = 0; k < 3; ++k) {
        sum.add(position_a[k], velocity_a[k]);
        sum.add(-position_a[k], velocity_b[k]);
        sum.add(-position_b[k], velocity_a[k]);
        sum.add(position_b[k], velocity_b[k]);
      }
      return sum;
    });
  };
  for (double left = approach(); left < 0; left = approach()) {
    add_along(normal, left, velocity_a);
  }
}

void keep_apart(const Vector3<double>& normal, Vector3<double>& velocity) {
  const auto approach = [&] {
    return approach_of(normal, velocity, [&] {
      impulse::ExactSum sum;
      for (int k = 0; k < 3; ++k) {
        sum.add(normal[k], velocity[k]);
      }
      return sum;
    });
  };
  for (double left = approach(); left < 0; left = approach()) {
    add_along(normal, left, velocity);
  }
}

}  // namespace carom::scene
