// SPDX-License-Identifier: BSL-1.0
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include <ode/ode.h>

#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/engines/engines.hpp>
#include <carom/subjects/engines/unit.hpp>
#include <carom/subjects/session.hpp>

namespace carom::subjects {
namespace {

static_assert(std::is_same_v<dReal, double>, "needs the double build of ODE");

template <auto destroy>
struct Destroy {
  void operator()(auto* object) const { destroy(object); }
};
using Threading = std::unique_ptr<dxThreadingImplementation, Destroy<dThreadingFreeImplementation>>;
using World = std::unique_ptr<dxWorld, Destroy<dWorldDestroy>>;
using OdeBody = std::unique_ptr<dxBody, Destroy<dBodyDestroy>>;
using Joint = std::unique_ptr<dxJoint, Destroy<dJointDestroy>>;

/// ODE's own handler of a failed assertion ends the process.
[[noreturn]] void throw_assertion(int, const char* format, va_list arguments) {
  char message[256];
  std::vsnprintf(message, sizeof message, format, arguments);
  throw std::runtime_error(message);
}

/// ODE is initialised once, and told of each thread that calls it.
void enter_thread() {
  [[maybe_unused]] static const int library = (dSetDebugHandler(throw_assertion), dInitODE2(0));
  [[maybe_unused]] thread_local const int thread = dAllocateODEDataForThread(dAllocateFlagBasicData);
}

OdeBody make_body(const World& world, const Body& body, bool configured) {
  OdeBody made(dBodyCreate(world.get()));
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

BodyVelocity<long double> velocity_of(const OdeBody& body) {
  using Read = Eigen::Map<const Vector3<double>>;
  return {Read(dBodyGetLinearVel(body.get())).cast<long double>(), Read(dBodyGetAngularVel(body.get())).cast<long double>()};
}

Answer solve(const Collision& collision, bool configured) try {
  enter_thread();
  // The threading implementation that worlds have by default is one for all of them, and not safe in several threads.
  const Threading threading(dThreadingAllocateSelfThreadedImplementation());
  const World world(dWorldCreate());
  dWorldSetStepThreadingImplementation(world.get(), dThreadingImplementationGetFunctions(threading.get()),
                                       threading.get());
  if (configured) {
    dWorldSetCFM(world.get(), 0);
    dWorldSetERP(world.get(), 0);
  }
  const OdeBody a = make_body(world, collision.a, configured);
  const OdeBody b = make_body(world, collision.b, configured);
  const dContact contact = make_contact(collision);
  const Joint joint(dJointCreateContact(world.get(), nullptr, &contact));
  dJointAttach(joint.get(), a.get(), b.get());
  // With no torque and no correction left the length of the step cancels out; 1 s adds no rounding.
  dWorldStep(world.get(), configured ? 1.0 : 1.0 / 60.0);
  return ReportedOutcome{velocity_of(a), velocity_of(b)};
} catch (const std::runtime_error& assertion) {
  return Refused{std::string("ODE: ") + assertion.what()};
}

Session session(bool configured) {
  return session_of([configured](const Collision& collision) { return solve(collision, configured); });
}

}  // namespace

std::vector<Subject> ode_subjects() {
  std::vector<Subject> subjects = ode_claims();
  subjects[0].open = [] { return session(true); };
  subjects[1].open = [] { return session(false); };
  return subjects;
}

}  // namespace carom::subjects
