// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>
#include <type_traits>

#include <carom/collision/expects.hpp>
#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/impulse/numbers/exact_sum.hpp>
#include <carom/impulse/reflection.hpp>
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
Outcome<double> in_double(const Outcome<S>& outcome) {
  return map_outcome<double>(outcome, [](const S& x) { return static_cast<double>(x); });
}

template <class S>
Outcome<double> struck_spheres_in(Law law, const Collision& collision) {
  using impulse::Ldlt;
  using Inertia = impulse::PrincipalInertia<S, impulse::Moments::equal>;
  impulse::Contact<S, Inertia> contact = impulse::make_contact<S, Inertia>(collision);
  switch (law) {
    case Law::frictionless:
    case Law::reflection: {
      // The lever arms lie along the normal, so they do not change the impulse.
      contact.a.lever_arm.setConstant(S(0));
      contact.b.lever_arm.setConstant(S(0));
      Outcome<double> result = in_double(impulse::frictionless<S, Inertia>(contact));
      // Rounding to S would change the spins, which the impulse does not affect.
      result.a.angular_velocity = collision.a.angular_velocity;
      result.b.angular_velocity = collision.b.angular_velocity;
      return result;
    }
    case Law::sticking:
      return in_double(impulse::sticking<Ldlt, S, Inertia>(contact));
    case Law::coulomb:
      contact.tangential_restitution = S(0);
      break;
    case Law::rough:
    case Law::any:
      break;
  }
  return in_double(impulse::rough<Ldlt, S, Inertia>(contact));
}

template <class S>
Outcome<double> struck_bodies_in(Law law, const Collision& collision) {
  using impulse::Ldlt;
  const impulse::Contact<S> contact = impulse::make_contact<S>(collision);
  switch (law) {
    case Law::frictionless:
      return in_double(impulse::frictionless<S>(contact));
    case Law::reflection:
      return in_double(impulse::reflection<Ldlt, S>(contact));
    case Law::sticking:
      return in_double(impulse::sticking<Ldlt, S>(contact));
    case Law::coulomb: {
      // The search for the slip needs the elementary functions of a built-in type.
      using Searched = std::conditional_t<std::is_floating_point_v<S>, S, long double>;
      return in_double(impulse::coulomb(impulse::make_contact<Searched>(collision)));
    }
    case Law::rough:
    case Law::any:
      break;
  }
  return in_double(impulse::rough<Ldlt, S>(contact));
}

/// Restores the velocities of immovable bodies, because rounding to the solver's precision changes them.
Outcome<double> with_immovable_kept(Outcome<double> outcome, const Collision& collision) {
  const Outcome<double> before = unchanged(collision);
  if (collision.a.immovable) {
    outcome.a = before.a;
  }
  if (collision.b.immovable) {
    outcome.b = before.b;
  }
  return outcome;
}

/// The outcome that solve(S()) computes, with S the number type of the precision.
template <class Solve>
Outcome<double> solved_in(Precision precision, const Collision& collision, const Solve& solve) {
  switch (precision) {
    case Precision::binary32:
      return with_immovable_kept(solve(float()), collision);
    case Precision::binary64:
      return with_immovable_kept(solve(double()), collision);
    case Precision::extended:
      break;
  }
  return with_immovable_kept(solve(impulse::DoubleDouble()), collision);
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
  return solved_in(precision, collision, [&]<class S>(const S&) { return struck_spheres_in<S>(law, collision); });
}

Outcome<double> struck_bodies(Law law, Precision precision, const Collision& collision) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  CAROM_EXPECTS(law != Law::any);
  return solved_in(precision, collision, [&]<class S>(const S&) { return struck_bodies_in<S>(law, collision); });
}

double parting_speed(const Collision& collision) {
  return impulse::normal_velocity(impulse::make_contact<double>(collision)) /
         impulse::without_extreme_length<double>(collision.normal).norm();
}

Outcome<double> sent_apart(const Collision& collision, double speed) {
  impulse::Contact<double> contact = impulse::make_contact<double>(collision);
  // The impulse is that of a plastic impact (ε = 0) at the missing speed.
  contact.restitution = 0;
  const double missing = impulse::normal_velocity(contact) - speed * contact.normal.norm();
  return with_immovable_kept(impulse::apply_impulse(contact, impulse::frictionless_impulse(contact, missing)),
                             collision);
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
