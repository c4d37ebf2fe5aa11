// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include <carom/collision/vector.hpp>
#include <carom/properties/families/adjustment.hpp>

namespace carom::properties {

/// A stream of integers that decides everything a family draws. The gate, RapidCheck and fuzzers each supply one.
/// Numbers are made of them by + − × ÷ alone, so that the same integers give the same collision on every machine.
class Stream {
 public:
  explicit Stream(std::function<std::uint64_t()> next) : next_(std::move(next)) {}

  [[nodiscard]] std::uint64_t bits() { return next_(); }

  /// Uniform in low … high, both included.
  [[nodiscard]] int integer(int low, int high);

  /// True once in `one_in` times.
  [[nodiscard]] bool chance(int one_in) { return integer(1, one_in) == 1; }

  /// In [0, 1): mostly with all 53 bits, at times a multiple of 1/8, so that special values come up.
  [[nodiscard]] double unit();

  /// In (-1, 1), of the same kind.
  [[nodiscard]] double signed_unit();

  /// In [low, high).
  [[nodiscard]] double between(double low, double high);

  /// 2^k with k in low … high.
  [[nodiscard]] double power_of_two(int low, int high);

  /// 10^k with k in low … high, |k| ≤ 30.
  [[nodiscard]] double power_of_ten(int low, int high);

  /// Components in (-1, 1).
  [[nodiscard]] Vector3<double> vector();

  /// The same, never zero; at times with small integer components.
  [[nodiscard]] Vector3<double> direction();

  /// A quaternion of any length from about 1/8 to 2.
  [[nodiscard]] Quaternion<double> quaternion();

  /// Notes that the collision that is being drawn was changed.
  void note(Adjustment adjustment) { adjusted_[adjustment] = true; }
  /// Notes that it is drawn again. Changes of the one before do not count.
  void note_drawn_again() {
    adjusted_ = {};
    note(Adjustment::drawn_again);
  }
  [[nodiscard]] const PerAdjustment<bool>& adjusted() const { return adjusted_; }

 private:
  std::function<std::uint64_t()> next_;
  PerAdjustment<bool> adjusted_;
};

/// 10^k, |k| ≤ 30: the nearest double, or for k < 0 one divided by it.
[[nodiscard]] double power_of_ten(int k);

/// The stream of one case: SplitMix64 (G. Steele, D. Lea, C. Flood, OOPSLA 2014), started from the seed, the family's
/// name and the number of the case, so that every case can be made by itself.
[[nodiscard]] Stream case_stream(std::uint64_t seed, std::string_view family, std::uint64_t index);

/// The stream that a single integer starts.
[[nodiscard]] Stream stream_from(std::uint64_t seed);

}  // namespace carom::properties
