// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdarg>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

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

/// By default, all worlds share one threading implementation, which is not thread-safe. It must not be freed in the
/// middle of a step.
inline Threading own_threading() {
  enter_thread();
  return Threading(dThreadingAllocateSelfThreadedImplementation());
}

}  // namespace carom::subjects::ode
