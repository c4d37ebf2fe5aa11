// SPDX-License-Identifier: BSL-1.0
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include <carom/properties/gate/in_parallel.hpp>

namespace carom::properties {

void in_parallel(unsigned jobs, std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr first;
  const auto run = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        work(i);
      }
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      first = first ? first : std::current_exception();
    }
  };
  std::vector<std::jthread> threads;
  try {
    for (unsigned i = 1; i < jobs; ++i) {
      threads.emplace_back(run);
    }
  } catch (const std::system_error&) {
    // Those that there are do all of it.
  }
  run();
  threads.clear();
  if (first) {
    std::rethrow_exception(first);
  }
}

}  // namespace carom::properties
