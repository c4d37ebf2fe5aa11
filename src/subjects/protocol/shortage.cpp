// SPDX-License-Identifier: BSL-1.0

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <carom/subjects/protocol/shortage.hpp>

namespace carom::subjects::protocol {
namespace {

constexpr rlim_t kibibyte = 1024;

rlim_t limit_of(__rlimit_resource_t resource) {
  rlimit limit{};
  return getrlimit(resource, &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

/// Whether a thread finds memory for its stack. Its size is the limit on stacks, or the default of glibc.
bool has_memory_for_a_stack() {
  constexpr rlim_t of_glibc = 8192 * kibibyte;
  const rlim_t limit = limit_of(RLIMIT_STACK);
  const std::size_t size = limit == RLIM_INFINITY ? of_glibc : limit;
  void* const stack = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0);
  return stack != MAP_FAILED && munmap(stack, size) == 0;
}

std::string of_memory() {
  const rlim_t limit = limit_of(RLIMIT_AS);
  return limit == RLIM_INFINITY
             ? "the system has too little memory"
             : fmt::format("memory is short: at most {} KiB may be used (ulimit -v)", limit / kibibyte);
}

std::string of_processes() {
  const rlim_t limit = limit_of(RLIMIT_NPROC);
  return limit == RLIM_INFINITY
             ? "processes and threads are short: ulimit -u has no limit, but the system or the container has one"
             : fmt::format("processes and threads are short: this user may have at most {} (ulimit -u)", limit);
}

}  // namespace

std::string shortage(const std::error_code& error) {
  if (error == std::errc::resource_unavailable_try_again) {
    return has_memory_for_a_stack() ? of_processes() : of_memory();
  }
  if (error == std::errc::not_enough_memory) {
    return of_memory();
  }
  if (error == std::errc::too_many_files_open) {
    return fmt::format("files are short: at most {} may be open (ulimit -n)", limit_of(RLIMIT_NOFILE));
  }
  return "";
}

std::string message_of(const std::error_code& error) {
  const std::string what = shortage(error);
  return what.empty() ? error.message() : fmt::format("{} ({})", error.message(), what);
}

}  // namespace carom::subjects::protocol
