// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/report/chart/measurement.hpp>
#include <carom/subjects/methods.hpp>

namespace carom::tool::chart {

/// Contacts that are timed together: few enough that they stay in the first-level cache, in any layout.
inline constexpr std::size_t contacts_in_kernel = 64;

/// What one kernel is timed for: the method, and the collisions of one family.
struct TimedKernel {
  const subjects::Method* method;
  std::span<const Collision> collisions;  // not empty
};

/// Nanoseconds for each contact of each kernel, by Google Benchmark: so many repetitions in a random order, so that a
/// disturbance of the machine does not hit one kernel alone. `progress(done, all)` where given.
[[nodiscard]] std::vector<report::Spread> measured_times(
    std::span<const TimedKernel> kernels, int repetitions,
    const std::function<void(std::uint64_t, std::uint64_t)>& progress);

}  // namespace carom::tool::chart
