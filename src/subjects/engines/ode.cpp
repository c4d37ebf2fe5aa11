// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <type_traits>

#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/engines/engines.hpp>
#include <carom/subjects/engines/ode_handles.hpp>
#include <carom/subjects/engines/unit.hpp>
#include <carom/subjects/session.hpp>

namespace carom::subjects {
namespace {

static_assert(std::is_same_v<dReal, double>, "needs the double build of ODE");

ode::World make_world(dThreadingImplementationID threading, bool configured) {
  ode::World world(dWorldCreate());
  dWorldSetStepThreadingImplementation(world.get(), dThreadingImplementationGetFunctions(threading), threading);
  const dWorldStepReserveInfo minimum{sizeof minimum, 1, 0};  // a failed assertion leaks the memory of its step
  dWorldSetStepMemoryReservationPolicy(world.get(), &minimum);
  if (configured) {
    dWorldSetCFM(world.get(), 0);  // ERP needs no change: a contact of depth 0 leaves it nothing to act on
  }
  return world;
}

ode::RigidBody make_body(const ode::World& world, const Body& body, bool configured) {
  ode::RigidBody made(dBodyCreate(world.get()));
  if (body.immovable) {
    dBodySetKinematic(made.get());
  } else {
    const Vector3<double>& moments = body.principal_inertia;
    dMass mass;
    dMassSetParameters(&mass, body.mass, 0, 0, 0, moments.x(), moments.y(), moments.z(), 0, 0, 0);
    dBodySetMass(made.get(), &mass);
    dBodySetQuaternion(made.get(), unit(body.orientation).data());  // w, x, y, z, as here
  }
  if (configured) {
    dBodySetGyroscopicMode(made.get(), 0);
  }
  dBodySetPosition(made.get(), body.position.x(), body.position.y(), body.position.z());
  dBodySetLinearVel(made.get(), body.velocity.x(), body.velocity.y(), body.velocity.z());
  dBodySetAngularVel(made.get(), body.angular_velocity.x(), body.angular_velocity.y(), body.angular_velocity.z());
  return made;
}

/// Depth 0, for the protocol has none; friction 0, for the model has none; bounce_vel, which has no default, 0.
dContact make_contact(const Collision& collision) {
  dContact contact{};
  contact.surface.mode = dContactBounce;
  contact.surface.bounce = collision.restitution;
  Eigen::Map<Vector3<double>>(contact.geom.pos) = collision.point;
  Eigen::Map<Vector3<double>>(contact.geom.normal) = unit(collision.normal);  // into the first body, A
  return contact;
}

BodyVelocity<long double> velocity_of(const ode::RigidBody& body) {
  const Eigen::Map<const Vector3<double>> velocity(dBodyGetLinearVel(body.get()));
  const Eigen::Map<const Vector3<double>> angular_velocity(dBodyGetAngularVel(body.get()));
  return {velocity.cast<long double>(), angular_velocity.cast<long double>()};
}

ReportedOutcome step(const Collision& collision, bool configured, dThreadingImplementationID threading) {
  const ode::World world = make_world(threading, configured);
  const ode::RigidBody a = make_body(world, collision.a, configured);
  const ode::RigidBody b = make_body(world, collision.b, configured);
  const dContact contact = make_contact(collision);
  const ode::Joint joint(dJointCreateContact(world.get(), nullptr, &contact));
  dJointAttach(joint.get(), a.get(), b.get());
  dWorldStep(world.get(), 1.0 / 60.0);  // [s]; configured, its length enters nothing
  return {velocity_of(a), velocity_of(b)};
}

Answer solve(const Collision& collision, bool configured) {
  ode::enter_thread();
  // The threading implementation that worlds have by default is one for all of them, and not safe in several threads.
  ode::Threading threading(dThreadingAllocateSelfThreadedImplementation());
  try {
    return step(collision, configured, threading.get());
  } catch (const ode::AssertionFailed& failure) {
    static_cast<void>(threading.release());  // ODE does not let it be freed in the middle of a step
    return Refused{std::string("ODE: ") + failure.what()};
  }
}

}  // namespace

std::vector<Subject> ode_subjects() {
  std::vector<Subject> subjects = ode_claims();
  for (Subject& subject : subjects) {
    subject.version = dODE_VERSION;
  }
  for (const bool configured : {true, false}) {
    subjects[configured ? 0 : 1].open = [configured] {
      return session_of([configured](const Collision& collision) { return solve(collision, configured); });
    };
  }
  return subjects;
}

}  // namespace carom::subjects
