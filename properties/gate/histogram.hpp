// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <carom/collision/expects.hpp>

namespace carom::properties {

/// Counts numbers in the fixed bins of a scale. So the size of a histogram is bounded, and the order of the numbers
/// does not matter.
template <class Scale>
class Histogram {
 public:
  void add(double number) {
    const std::size_t bin = Scale::bin_of(number);
    if (counts_.size() <= bin) {
      counts_.resize(bin + 1);
    }
    ++counts_[bin];
    ++size_;
    smallest_ = std::min(smallest_, number);
    largest_ = std::max(largest_, number);
  }

  Histogram& operator+=(const Histogram& other) {
    counts_.resize(std::max(counts_.size(), other.counts_.size()));
    for (std::size_t bin = 0; bin < other.counts_.size(); ++bin) {
      counts_[bin] += other.counts_[bin];
    }
    size_ += other.size_;
    smallest_ = std::min(smallest_, other.smallest_);
    largest_ = std::max(largest_, other.largest_);
    return *this;
  }

  /// The histogram with these `counts()`, `smallest()` and `largest()`. Preconditions: at most Scale::bins counts;
  /// smallest ≤ largest if any count is not 0.
  [[nodiscard]] static Histogram restored(std::vector<std::uint64_t> counts, double smallest, double largest) {
    CAROM_EXPECTS(counts.size() <= Scale::bins, counts.size());
    Histogram histogram;
    histogram.counts_.swap(counts);
    histogram.size_ = std::accumulate(histogram.counts_.begin(), histogram.counts_.end(), std::uint64_t{0});
    histogram.smallest_ = smallest;
    histogram.largest_ = largest;
    CAROM_EXPECTS(histogram.size_ == 0 || smallest <= largest, smallest, largest);
    return histogram;
  }

  /// The count of each bin, up to the last nonempty bin.
  [[nodiscard]] const std::vector<std::uint64_t>& counts() const { return counts_; }

  /// The smallest and the largest number added; ∞ and −∞ if there is none.
  [[nodiscard]] double smallest() const { return smallest_; }
  [[nodiscard]] double largest() const { return largest_; }

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// The number of stored bins, at most Scale::bins.
  [[nodiscard]] std::size_t bins() const { return counts_.size(); }

  /// The added number with this rank in ascending order. The smallest number has rank 0. The smallest and the largest
  /// number are exact. For any other rank, returns the middle of the number's bin, clamped to smallest() and largest().
  /// Precondition: rank < size().
  [[nodiscard]] double at(std::uint64_t rank) const {
    CAROM_EXPECTS(rank < size_, rank, size_);
    if (rank == 0 || rank + 1 == size_) {
      return rank == 0 ? smallest_ : largest_;
    }
    std::size_t bin = 0;
    for (std::uint64_t below = counts_[0]; below <= rank; below += counts_[bin]) {
      ++bin;
    }
    return std::clamp(Scale::middle_of(bin), smallest_, largest_);
  }

 private:
  std::vector<std::uint64_t> counts_;
  std::uint64_t size_ = 0;
  double smallest_ = std::numeric_limits<double>::infinity();
  double largest_ = -std::numeric_limits<double>::infinity();
};

/// Correct digits in bins of 0.01 from −20 to 40. 40 stands for an exact outcome. The middle of a bin rounds to the
/// same tenth as every number in the bin. One more bin, with the middle −∞, holds everything below −20, and NaN.
struct DigitsScale {
  static constexpr int lowest = -20;
  static constexpr int highest = 40;
  static constexpr int of_each = 100;
  static constexpr std::size_t bins = 2 + (highest - lowest) * of_each;  // two more: below −20, and 40 itself

  [[nodiscard]] static std::size_t bin_of(double digits) {
    if (!(digits >= lowest)) {
      return 0;
    }
    return 1 + static_cast<std::size_t>((std::fmin(digits, highest) - lowest) * of_each);
  }

  [[nodiscard]] static double middle_of(std::size_t bin) {
    if (bin == 0) {
      return -std::numeric_limits<double>::infinity();
    }
    return (2 * static_cast<double>(bin) - 1) / (2 * of_each) + lowest;
  }
};

/// Times in nanoseconds from 2⁻¹⁰ to 2⁵⁴ (half a year), in 64 bins per octave. The middle of a bin has a relative error
/// below 1/128. The outer bins also hold the times outside this range.
struct TimeScale {
  static constexpr int lowest_exponent = -9;  // of std::frexp: 2⁻¹⁰ is ½ · 2⁻⁹
  static constexpr int octaves = 64;
  static constexpr int of_each = 64;
  static constexpr std::size_t bins = std::size_t{octaves} * of_each;

  [[nodiscard]] static std::size_t bin_of(double nanoseconds) {
    int exponent = 0;
    const double mantissa = std::frexp(nanoseconds, &exponent);  // from ½ to 1
    if (!(nanoseconds > 0) || exponent < lowest_exponent) {
      return 0;
    }
    if (exponent >= lowest_exponent + octaves) {
      return bins - 1;
    }
    return static_cast<std::size_t>((exponent - lowest_exponent) * of_each) +
           static_cast<std::size_t>((2 * mantissa - 1) * of_each);
  }

  [[nodiscard]] static double middle_of(std::size_t bin) {
    const auto octave = static_cast<int>(bin / of_each);
    const auto part = static_cast<double>(bin % of_each);
    return std::ldexp(1 + (part + 0.5) / of_each, octave + lowest_exponent - 1);
  }
};

}  // namespace carom::properties
