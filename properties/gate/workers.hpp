// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>

namespace carom::properties {

inline void in_turn(std::size_t count, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) {
    work(i);
  }
}

/// The threads of a run. The judge's libraries start no threads, but a caller may supply some.
struct Workers {
  /// The number of items of work that may run at once, at least 1. It does not affect results.
  unsigned count = 1;
  /// Runs work(0), …, work(count − 1), each once and in any order, and returns after the last. After an exception,
  /// starts no further work, and throws the first exception.
  std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)> run = in_turn;
};

}  // namespace carom::properties
