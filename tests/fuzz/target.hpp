// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

/// The function that a fuzzing engine calls with each input. Every target defines it. A finding ends the process, by
/// `fail`, by an uncaught exception, or by a sanitizer.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace carom::fuzz {

/// Ends the process as a finding, which the text describes.
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
