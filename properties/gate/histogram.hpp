// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
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

}  // namespace carom::properties
