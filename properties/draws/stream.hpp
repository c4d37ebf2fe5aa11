// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>

#include <carom/collision/collision.hpp>
#include <carom/collision/enum_array.hpp>
#include <carom/collision/vector.hpp>

namespace carom::properties {

/// A change that a family makes to a case after drawing it. It does not depend on any solver.
enum class Adjustment {
  moments_enlarged,  // enlarged until the contact lies within twice the radius of gyration
  moved_to_origin,   // the contact is at the origin, so that parallel vectors are exactly parallel
  reversed,          // because the bodies separated
  drawn_again,       // because masses, sizes or speeds left the domain
};
inline constexpr std::array all_adjustments{Adjustment::moments_enlarged, Adjustment::moved_to_origin,
                                            Adjustment::reversed, Adjustment::drawn_again};
static_assert(counts_from_zero_to(all_adjustments, Adjustment::drawn_again));

template <class T>
using PerAdjustment = EnumArray<Adjustment, T, all_adjustments.size()>;

using AdjustmentCounts = PerAdjustment<std::uint64_t>;

[[nodiscard]] std::string_view name_of(Adjustment adjustment);

/// A question that a family asks its stream, with the answers 0 … count − 1. The answer `simplest` gives the simplest
/// collisions.
struct StreamQuestion {
  std::uint64_t count;
  std::uint64_t simplest = 0;
  bool is_of_plainness = false;  // asked by `plainly`
};

/// The number of fractions k 2⁻⁵³ in [0, 1).
inline constexpr std::uint64_t fractions = std::uint64_t{1} << 53U;

/// A stream of integers that decides everything that a family draws. The integers are 64-bit words in the gate and the
/// fuzzers, and answers to questions with RapidCheck. Numbers come from the integers by + − × ÷ alone, so they are the
/// same on every machine.
class Stream {
 public:
  explicit Stream(std::function<std::uint64_t()> next) : next_(std::move(next)) {}

  /// Precondition: `answer` returns less than the question's `count`.
  explicit Stream(std::function<std::uint64_t(const StreamQuestion&)> answer) : answer_(std::move(answer)) {}

  [[nodiscard]] std::uint64_t bits();

  /// Uniform in 0 … count − 1.
  [[nodiscard]] std::uint64_t below(std::uint64_t count, std::uint64_t simplest = 0) {
    return answer_ ? answer_({count, simplest, false}) : next_() % count;
  }

  /// Uniform in low … high, both included. The simplest answer is `simplest`, or without it the number closest to 0.
  [[nodiscard]] int integer(int low, int high) { return integer(low, high, std::clamp(0, low, high)); }
  [[nodiscard]] int integer(int low, int high, int simplest);

  /// True once in `one_in` times. The simplest answer is false.
  [[nodiscard]] bool chance(int one_in) { return integer(1, one_in, one_in == 1 ? 1 : 2) == 1; }

  /// Whether to use a plain number, such as 1, in place of the drawn number. A stream of words answers false, and takes
  /// no word for the answer.
  [[nodiscard]] bool plainly() { return answer_ && answer_({2, 1, true}) == 1; }

  /// In [0, 1): mostly with all 53 bits; one in eight is a multiple of 1/8.
  [[nodiscard]] double unit();

  /// `unit()` with a random sign, in (-1, 1).
  [[nodiscard]] double signed_unit();

  /// In [low, high).
  [[nodiscard]] double between(double low, double high);

  /// 2^k with k in low … high.
  [[nodiscard]] double power_of_two(int low, int high);

  /// 10^k with k in low … high, |k| ≤ 30.
  [[nodiscard]] double power_of_ten(int low, int high);

  /// Components in (-1, 1).
  [[nodiscard]] Vector3<double> vector();

  /// Never zero. At times, its components are small integers.
  [[nodiscard]] Vector3<double> direction();

  /// A quaternion with a length from about 1/8 to 2.
  [[nodiscard]] Quaternion<double> quaternion();

  /// Families call `settle` for bodies that they have drawn. It puts them into the kinds of a domain (cases/kinds.hpp).
  /// Without `settle_by`, it does nothing.
  void settle(Collision& collision) {
    if (settle_) {
      settle_(*this, collision);
    }
  }
  void settle_by(std::function<void(Stream&, Collision&)> settle) { settle_ = std::move(settle); }

  void note(Adjustment adjustment) { adjusted_[adjustment] = true; }
  /// Records that the collision is drawn again, and forgets the adjustments of the previous draw.
  void note_drawn_again() {
    adjusted_ = {};
    note(Adjustment::drawn_again);
  }
  [[nodiscard]] const PerAdjustment<bool>& adjusted() const { return adjusted_; }

 private:
  std::function<std::uint64_t()> next_;
  std::function<std::uint64_t(const StreamQuestion&)> answer_;  // empty only if `next_` is not
  std::function<void(Stream&, Collision&)> settle_;             // empty: nothing is changed
  PerAdjustment<bool> adjusted_;
};

/// The double nearest to 10^k; if k < 0, 1 divided by the double nearest to 10^−k. Precondition: |k| ≤ 30.
[[nodiscard]] double power_of_ten(int k);

/// The stream of one case: SplitMix64 (G. Steele, D. Lea, C. Flood, OOPSLA 2014). Its initial state depends only on the
/// seed, the family's name and the number of the case.
[[nodiscard]] Stream case_stream(std::uint64_t seed, std::string_view family, std::uint64_t index);

[[nodiscard]] Stream stream_from(std::uint64_t seed);

}  // namespace carom::properties
