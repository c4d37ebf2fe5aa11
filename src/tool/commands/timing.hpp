// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/report/pictures/measurement.hpp>
#include <carom/subjects/methods.hpp>

namespace carom::tool::chart {

/// The number of contacts that are timed together. They fit into the first-level cache.
inline constexpr std::size_t contacts_in_kernel = 64;

/// The input of one timed kernel: a method, and the collisions of one family.
struct TimedKernel {
  const subjects::Method* method;
  std::span<const Collision> collisions;  // not empty
};

/// The time of each kernel [ns for each contact], measured by Google Benchmark. The repetitions run in random order, so
/// that a disturbance of the machine affects all kernels. Calls `progress(done, all)` if it is set.
[[nodiscard]] std::vector<report::Spread> measured_times(
    std::span<const TimedKernel> kernels, int repetitions,
    const std::function<void(std::uint64_t, std::uint64_t)>& progress);

}  // namespace carom::tool::chart
