// SPDX-License-Identifier: BSL-1.0
#include "io/threads.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace carom::tool {
namespace {

void run_on_threads(unsigned jobs, std::size_t count, const std::function<void(std::size_t)>& work) {
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
    for (std::size_t i = 1; i < std::min<std::size_t>(jobs, count); ++i) {
      threads.emplace_back(run);
    }
  } catch (const std::system_error&) {
    // The started threads do all the work.
  }
  run();
  threads.clear();
  if (first) {
    std::rethrow_exception(first);
  }
}

}  // namespace

properties::Workers threads(unsigned jobs) {
  const unsigned count = jobs > 0 ? jobs : std::max(1U, std::thread::hardware_concurrency());
  return {count, [count](std::size_t items, const std::function<void(std::size_t)>& work) {
            run_on_threads(count, items, work);
          }};
}

}  // namespace carom::tool
