// SPDX-License-Identifier: BSL-1.0
#include "io/memory_reserve.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <new>
#include <string>

#include <gmp.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <carom/report/model/exit_status.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

/// The largest reserve [bytes]. The reports of a gate over all families and subjects need a third of it.
constexpr std::size_t most_reserved = std::size_t{64} << 20U;

constexpr rlim_t kibibyte = 1024;

struct Reserve {
  std::mutex mutex;
  void* memory = nullptr;
  std::size_t size = 0;
  std::stop_source stop;
};

Reserve& the_reserve() {
  static Reserve reserve;
  return reserve;
}

std::atomic<bool> has_run_out = false;

/// Releases the reserve. Returns whether the allocation should be tried again: true once for each thread.
bool give_free() {
  thread_local bool has_tried_again = false;
  if (has_tried_again) {
    return false;
  }
  has_tried_again = true;
  Reserve& reserve = the_reserve();
  const std::lock_guard lock(reserve.mutex);
  if (reserve.memory != nullptr) {
    munmap(reserve.memory, reserve.size);
    reserve.memory = nullptr;
    has_run_out = true;
    reserve.stop.request_stop();
  }
  return true;
}

void when_new_fails() {
  if (!give_free()) {
    throw std::bad_alloc();
  }
}

rlim_t limit_of(__rlimit_resource_t resource) {
  rlimit limit{};
  return getrlimit(resource, &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

[[noreturn]] void end_without_memory() {
  print_out_of_memory();
  _exit(report::exit_usage);
}

/// The terminate handler. Some destructors allocate memory, and an exception from a destructor ends the program.
[[noreturn]] void when_nothing_catches() {
  if (has_run_out) {
    end_without_memory();
  }
  std::abort();
}

/// Ends the program if there is no memory. GMP checks no allocation and cannot recover from an exception.
template <class Allocate>
void* allocated_for_gmp(const Allocate& allocate) {
  void* memory = allocate();
  if (memory == nullptr && give_free()) {
    memory = allocate();
  }
  if (memory == nullptr) {
    end_without_memory();
  }
  return memory;
}

/// The size of the reserve [bytes]. It is at most a quarter of the limit on memory, so that the program can start.
std::size_t reserved_size() {
  constexpr rlim_t part = 4;
  const rlim_t limit = limit_of(RLIMIT_AS);
  return limit == RLIM_INFINITY ? most_reserved : std::min<std::size_t>(most_reserved, limit / part);
}

constexpr std::size_t page = 4096;
constexpr std::size_t grown_pages = 128;  // several times the need of the main thread

/// Grows the stack of this thread. A stack that cannot grow later crashes the program.
void grow_stack() {
  volatile char touched[page * grown_pages];
  for (std::size_t i = 0; i < grown_pages; ++i) {
    touched[i * page] = 0;
    static_cast<void>(touched[i * page]);
  }
}

}  // namespace

void require_stack() {
  constexpr rlim_t least = 2 * page * grown_pages;  // with the environment, and with what is on the stack already
  if (const rlim_t limit = limit_of(RLIMIT_STACK); limit < least) {
    throw UsageError("the stack is short: at most " + std::to_string(limit / kibibyte) +
                     " KiB may be used (ulimit -s), expected at least " + std::to_string(least / kibibyte) + " KiB");
  }
}

void keep_memory_for_the_report(const std::stop_source& stop) {
  grow_stack();
  Reserve& reserve = the_reserve();
  reserve.stop = stop;
  reserve.size = reserved_size();
  void* memory = mmap(nullptr, reserve.size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    return;
  }
  reserve.memory = memory;
  std::set_new_handler(when_new_fails);
  std::set_terminate(when_nothing_catches);
  mp_set_memory_functions([](std::size_t size) { return allocated_for_gmp([=] { return std::malloc(size); }); },
                          [](void* old, std::size_t, std::size_t size) {
                            return allocated_for_gmp([=] { return std::realloc(old, size); });
                          },
                          [](void* memory_of_gmp, std::size_t) { std::free(memory_of_gmp); });
}

void print_out_of_memory() {
  std::fputs("carom: there is not enough memory", stderr);
  if (const rlim_t limit = limit_of(RLIMIT_AS); limit != RLIM_INFINITY) {
    constexpr std::size_t size = 100;
    char text[size];
    std::snprintf(text, size, ": at most %llu KiB may be used (ulimit -v)",
                  static_cast<unsigned long long>(limit / kibibyte));
    std::fputs(text, stderr);
  }
  std::fputs("\n", stderr);
}

bool has_run_out_of_memory() { return has_run_out; }

}  // namespace carom::tool
