// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

/// A fuzzing engine calls this function with each input. Every target defines it. `fail`, an uncaught exception or a
/// sanitizer ends the process, which is a finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace carom::fuzz {

/// Ends the process as a finding with this description.
[[noreturn]] inline void fail(const std::string& what) {
  (void)std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

inline void require(bool holds, const char* what) {
  if (!holds) {
    fail(what);
  }
}

}  // namespace carom::fuzz
