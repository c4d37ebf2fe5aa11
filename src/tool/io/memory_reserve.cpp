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

#include <gmp.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <carom/report/model/exit_status.hpp>

namespace carom::tool {
namespace {

/// The largest reserve [bytes]. The reports of a gate over all families and subjects need a third of it.
constexpr std::size_t most_reserved = std::size_t{64} << 20U;

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

[[noreturn]] void end_without_memory() {
  std::fputs(out_of_memory, stderr);
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
  rlimit limit{};
  constexpr rlim_t part = 4;
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    return std::min<std::size_t>(most_reserved, limit.rlim_cur / part);
  }
  return most_reserved;
}

/// Grows the stack of this thread to 1 MiB, several times its need. A stack that cannot grow later crashes the program.
void grow_stack() {
  constexpr std::size_t page = 4096;
  constexpr std::size_t pages = 256;
  volatile char touched[page * pages];
  for (std::size_t i = 0; i < pages; ++i) {
    touched[i * page] = 0;
    static_cast<void>(touched[i * page]);
  }
}

}  // namespace

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

bool has_run_out_of_memory() { return has_run_out; }

}  // namespace carom::tool
