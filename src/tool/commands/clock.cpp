// SPDX-License-Identifier: BSL-1.0
#include "commands/clock.hpp"

#include <algorithm>
#include <stdexcept>

#include <carom/collision/expects.hpp>
#include <carom/subjects/methods.hpp>

#include "commands/timing.hpp"
#include "io/output.hpp"

namespace carom::tool::plan {
namespace {

const subjects::Method& method_named(const std::vector<subjects::Method>& methods, const std::string& name) {
  const auto found =
      std::ranges::find_if(methods, [&](const subjects::Method& method) { return method.subject.name == name; });
  if (found == methods.end()) {
    throw std::logic_error(name + " is not a built-in method");
  }
  return *found;
}

}  // namespace

properties::plan::Clock clock_of(int repetitions) {
  CAROM_EXPECTS(repetitions > 0, repetitions);
  static_assert(properties::plan::contacts_timed == chart::contacts_in_kernel, "each sample is one kernel");
  return [repetitions](std::span<const properties::plan::Timing> timings) {
    const std::vector<subjects::Method> methods = subjects::methods();
    std::vector<chart::TimedKernel> kernels;
    for (const properties::plan::Timing& timing : timings) {
      kernels.push_back({&method_named(methods, timing.candidate->subject.name), timing.collisions});
    }
    std::vector<double> nanoseconds;
    for (const report::Spread& spread : chart::measured_times(kernels, repetitions, progress_line("timings"))) {
      nanoseconds.push_back(spread.median);
    }
    return nanoseconds;
  };
}

}  // namespace carom::tool::plan
