// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <type_traits>

#include <carom/subjects/engines.hpp>
#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/engines/ode_handles.hpp>
#include <carom/subjects/session.hpp>

namespace carom::subjects {
namespace {

static_assert(std::is_same_v<dReal, double>, "needs the double build of ODE");

ode::World make_world(const ode::Threading& threading, bool configured) {
  ode::World world = ode::world_with(threading);
  const dWorldStepReserveInfo minimum{sizeof minimum, 1, 0};  // the least reserve, because a failed assertion leaks it
  dWorldSetStepMemoryReservationPolicy(world.get(), &minimum);
  if (configured) {
    dWorldSetCFM(world.get(), 0);  // ERP has no effect on a contact of depth 0
  }
  return world;
}

ode::RigidBody make_body(const ode::World& world, const Body& body, bool configured) {
  ode::RigidBody made(dBodyCreate(world.get()));
  if (body.immovable) {
    dBodySetKinematic(made.get());
  } else {
    ode::set_mass(made.get(), body, body.orientation);
  }
  if (configured) {
    dBodySetGyroscopicMode(made.get(), 0);
  }
  ode::set_motion(made.get(), body);
  return made;
}

/// V_T⁻, the tangential relative velocity at the contact. Precondition: n = N has unit length.
Vector3<double> slip(const Collision& collision, const Vector3<double>& n) {
  const auto velocity_at_point = [&](const Body& body) -> Vector3<double> {
    return body.velocity + body.angular_velocity.cross(collision.point - body.position);
  };
  return n.cross((velocity_at_point(collision.a) - velocity_at_point(collision.b)).cross(n));
}

/// As shipped, μ limits the friction force. Configured, μ limits the ratio of the friction impulse to the normal
/// impulse, along the slip and across it.
void add_friction(dContact& contact, const Collision& collision, const Vector3<double>& n, bool configured) {
  contact.surface.mu = collision.friction;
  if (!configured) {
    return;
  }
  contact.surface.mode |= dContactApprox1;
  const Vector3<double> direction = slip(collision, n);
  if (!direction.isZero(0)) {
    contact.surface.mode |= dContactFDir1;
    Eigen::Map<Vector3<double>>(contact.fdir1) = unit(direction);
  }
}

/// The contact has depth 0, because a Collision has no depth. bounce_vel has no default in ODE, and is 0.
dContact make_contact(const Collision& collision, const EngineSetting& setting) {
  const Vector3<double> n = unit(collision.normal);
  dContact contact{};
  contact.surface.mode = dContactBounce;
  contact.surface.bounce = collision.restitution;
  Eigen::Map<Vector3<double>>(contact.geom.pos) = collision.point;
  Eigen::Map<Vector3<double>>(contact.geom.normal) = n;  // points into the first body, A
  if (setting.law == Law::coulomb) {
    add_friction(contact, collision, n, setting.configured);
  }
  return contact;
}

BodyVelocity<long double> velocity_of(const ode::RigidBody& body) {
  return {ode::from_ode(dBodyGetLinearVel(body.get())).cast<long double>(),
          ode::from_ode(dBodyGetAngularVel(body.get())).cast<long double>()};
}

ReportedOutcome step(const Collision& collision, const EngineSetting& setting, ode::Threading& threading) {
  const ode::World world = make_world(threading, setting.configured);
  const ode::RigidBody a = make_body(world, collision.a, setting.configured);
  const ode::RigidBody b = make_body(world, collision.b, setting.configured);
  const dContact contact = make_contact(collision, setting);
  const ode::Joint joint(dJointCreateContact(world.get(), nullptr, &contact));
  dJointAttach(joint.get(), a.get(), b.get());
  ode::step(world, 1.0 / 60.0, threading);  // [s]; does not affect the configured engine's answer
  return {velocity_of(a), velocity_of(b)};
}

Answer solve(const Collision& collision, const EngineSetting& setting) {
  ode::last_warning.clear();
  ode::Threading threading = ode::own_threading();
  try {
    return step(collision, setting, threading);
  } catch (const ode::AssertionFailed& failure) {
    const std::string& warning = ode::last_warning;
    return Refused{std::string("ODE: ") + failure.what() + (warning.empty() ? "" : ", after the warning: " + warning)};
  }
}

}  // namespace

std::vector<Subject> ode_subjects() {
  std::vector<Subject> subjects = ode_claims();
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    subjects[i].version = dODE_VERSION;
    subjects[i].open = [&setting = engine_settings[i]] {
      return session_of([&setting](const Collision& collision) { return solve(collision, setting); });
    };
  }
  return subjects;
}

}  // namespace carom::subjects
