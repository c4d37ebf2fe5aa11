// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>

namespace carom::properties {

/// Runs work(0), …, work(count − 1) in this order.
inline void in_turn(std::size_t count, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) {
    work(i);
  }
}

/// The threads that do the work of a run. The libraries of the judge start no thread; the caller may supply threads.
struct Workers {
  /// The number of items of work that may run at once, at least 1. The results of a run do not depend on it.
  unsigned count = 1;
  /// Runs work(0), …, work(count − 1), each once, in any order, and returns when all have ended. If one throws, no
  /// further one starts, and the first exception is thrown.
  std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)> run = in_turn;
};

}  // namespace carom::properties
