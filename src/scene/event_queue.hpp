// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <carom/scene/motion.hpp>

namespace carom::scene {

/// A time for each sphere, and whose is the least: a tournament, so that a change costs log₂ of their number (D. Knuth,
/// "The Art of Computer Programming" 3, 5.4.1).
class EventQueue {
 public:
  using Index = std::uint32_t;

  explicit EventQueue(std::size_t count = 0) {
    while (leaves_ < count) {
      leaves_ *= 2;
    }
    times_.assign(leaves_, never);
    winners_.resize(2 * leaves_);
    for (std::size_t k = 0; k < leaves_; ++k) {
      winners_[leaves_ + k] = static_cast<Index>(k);
    }
    for (std::size_t node = leaves_ - 1; node >= 1; --node) {
      winners_[node] = winners_[2 * node];
    }
  }

  void set(Index index, double time) {
    times_[index] = time;
    for (std::size_t node = (leaves_ + index) / 2; node >= 1; node /= 2) {
      const Index left = winners_[2 * node];
      const Index right = winners_[2 * node + 1];
      const Index winner = times_[right] < times_[left] ? right : left;
      if (winner == winners_[node] && winner != index) {
        return;  // nothing above has changed either
      }
      winners_[node] = winner;
    }
  }

  [[nodiscard]] Index first() const { return winners_[1]; }
  [[nodiscard]] double time_of(Index index) const { return times_[index]; }

  /// Calls use(k) for each whose time is at most `latest`.
  template <class Use>
  void for_each_until(double latest, const Use& use) const {
    visit(1, latest, use);
  }

 private:
  template <class Use>
  void visit(std::size_t node, double latest, const Use& use) const {
    if (times_[winners_[node]] > latest) {
      return;
    }
    if (node >= leaves_) {
      use(winners_[node]);
      return;
    }
    visit(2 * node, latest, use);
    visit(2 * node + 1, latest, use);
  }

  std::size_t leaves_ = 1;
  std::vector<double> times_;
  std::vector<Index> winners_;  // of the heap's nodes from 1 on; the leaves last
};

}  // namespace carom::scene
