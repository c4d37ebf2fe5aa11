// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdarg>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include <ode/ode.h>

#include <carom/collision/vector.hpp>

namespace carom::subjects::ode {

template <auto destroy>
struct Destroy {
  void operator()(auto* object) const { destroy(object); }
};

using Threading = std::unique_ptr<dxThreadingImplementation, Destroy<dThreadingFreeImplementation>>;
using World = std::unique_ptr<dxWorld, Destroy<dWorldDestroy>>;
using RigidBody = std::unique_ptr<dxBody, Destroy<dBodyDestroy>>;
using Joint = std::unique_ptr<dxJoint, Destroy<dJointDestroy>>;
using Joints = std::unique_ptr<dxJointGroup, Destroy<dJointGroupDestroy>>;
using Space = std::unique_ptr<dxSpace, Destroy<dSpaceDestroy>>;

class AssertionFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline std::string in_words(const char* format, va_list arguments) {
  char text[256];
  std::vsnprintf(text, sizeof text, format, arguments);
  return text;
}

/// The last warning of ODE in this thread. ODE's own handler writes each warning to standard error.
inline thread_local std::string last_warning;
inline void keep_warning(int, const char* format, va_list arguments) { last_warning = in_words(format, arguments); }

/// Throws AssertionFailed, because ODE's own handler ends the process.
[[noreturn]] inline void throw_assertion(int, const char* format, va_list arguments) {
  throw AssertionFailed(in_words(format, arguments));
}

inline void enter_thread() {
  [[maybe_unused]] static const int library =
      (dSetDebugHandler(throw_assertion), dSetMessageHandler(keep_warning), dInitODE2(0));
  [[maybe_unused]] thread_local const int thread = dAllocateODEDataForThread(dAllocateFlagBasicData);
}

/// By default, all worlds share one threading implementation, which is not thread-safe.
inline Threading own_threading() {
  enter_thread();
  return Threading(dThreadingAllocateSelfThreadedImplementation());
}

/// A world that steps by this threading implementation.
inline World world_with(const Threading& threading) {
  World world(dWorldCreate());
  dWorldSetStepThreadingImplementation(world.get(), dThreadingImplementationGetFunctions(threading.get()),
                                       threading.get());
  return world;
}

/// After a failed assertion in the middle of a step, the threading implementation is never freed.
inline void step(const World& world, double seconds, Threading& threading) try {
  dWorldStep(world.get(), seconds);
} catch (const AssertionFailed&) {
  static_cast<void>(threading.release());
  throw;
}

inline Vector3<double> from_ode(const dReal* v) { return {v[0], v[1], v[2]}; }

/// The facts of a movable body. `Facts` is a `Body` or a `SteppedBody`.
template <class Facts>
void set_mass(dBodyID body, const Facts& facts, const Quaternion<double>& orientation) {
  const Vector3<double>& moments = facts.principal_inertia;
  dMass mass;
  dMassSetParameters(&mass, facts.mass, 0, 0, 0, moments.x(), moments.y(), moments.z(), 0, 0, 0);
  dBodySetMass(body, &mass);
  dBodySetQuaternion(body, unit(orientation).data());  // w, x, y, z, as in Carom
}

/// `State` is a `Body` or a `BodyState`.
template <class State>
void set_motion(dBodyID body, const State& state) {
  const auto set = [&](auto setter, const Vector3<double>& v) { setter(body, v.x(), v.y(), v.z()); };
  set(dBodySetPosition, state.position);
  set(dBodySetLinearVel, state.velocity);
  set(dBodySetAngularVel, state.angular_velocity);
}

}  // namespace carom::subjects::ode
