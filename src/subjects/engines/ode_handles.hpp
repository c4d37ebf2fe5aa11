// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdarg>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include <ode/ode.h>

namespace carom::subjects::ode {

template <auto destroy>
struct Destroy {
  void operator()(auto* object) const { destroy(object); }
};

using Threading = std::unique_ptr<dxThreadingImplementation, Destroy<dThreadingFreeImplementation>>;
using World = std::unique_ptr<dxWorld, Destroy<dWorldDestroy>>;
using RigidBody = std::unique_ptr<dxBody, Destroy<dBodyDestroy>>;
using Joint = std::unique_ptr<dxJoint, Destroy<dJointDestroy>>;

class AssertionFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws AssertionFailed, because ODE's own handler ends the process.
[[noreturn]] inline void throw_assertion(int, const char* format, va_list arguments) {
  char message[256];
  std::vsnprintf(message, sizeof message, format, arguments);
  throw AssertionFailed(message);
}

inline void enter_thread() {
  [[maybe_unused]] static const int library = (dSetDebugHandler(throw_assertion), dInitODE2(0));
  [[maybe_unused]] thread_local const int thread = dAllocateODEDataForThread(dAllocateFlagBasicData);
}

}  // namespace carom::subjects::ode
