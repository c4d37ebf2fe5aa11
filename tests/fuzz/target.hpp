// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#include <carom/properties/draws/stream.hpp>

/// Begins the function of a target, which a fuzzing engine calls with the bytes `data` of each input, and their `size`.
/// `fail`, an uncaught exception or a sanitizer ends the process, which is a finding. The program fuzz_replay has all
/// targets, so there each function has its own name.
#ifdef CAROM_REPLAYS_FILES
#define CAROM_FUZZ_TARGET(name) extern "C" int replay_##name(const std::uint8_t* data, std::size_t size)
#else
#define CAROM_FUZZ_TARGET(name) extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
#endif

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

using Bytes = std::span<const std::uint8_t>;

/// The fuzzer's input, read from the front. At the end of the input, a fixed stream of numbers continues it. So no
/// input is too short. A family that repeats a draw until the draw fits terminates, too.
class Input {
 public:
  explicit Input(Bytes bytes) : left_(bytes), beyond_(properties::stream_from(0)) {}

  [[nodiscard]] std::uint8_t byte() { return static_cast<std::uint8_t>(number_of(1)); }

  /// Eight bytes, the least significant first.
  [[nodiscard]] std::uint64_t word() { return number_of(sizeof(std::uint64_t)); }

  [[nodiscard]] double number() { return std::bit_cast<double>(word()); }

  [[nodiscard]] std::string_view text() const { return {reinterpret_cast<const char*>(left_.data()), left_.size()}; }

  /// A stream of the remaining words. The stream refers to this input.
  [[nodiscard]] properties::Stream stream() {
    return properties::Stream([this] { return word(); });
  }

 private:
  std::uint64_t number_of(std::size_t count) {
    if (left_.size() < count) {
      left_ = {};
      return beyond_.bits();
    }
    std::uint64_t number = 0;
    for (std::size_t i = count; i-- > 0;) {
      number = number << 8U | left_[i];
    }
    left_ = left_.subspan(count);
    return number;
  }

  Bytes left_;
  properties::Stream beyond_;
};

/// Compares numbers that were written and read again. Any NaN equals any other NaN.
template <class S>
[[nodiscard]] bool same_number(S x, S y) {
  return x == y || (std::isnan(x) && std::isnan(y));
}

}  // namespace carom::fuzz
