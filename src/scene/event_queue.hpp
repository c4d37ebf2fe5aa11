// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <carom/scene/arc.hpp>

namespace carom::scene {

/// The time of the next event of each sphere. `first` is the sphere with the least time; of equal times, the lowest
/// index. The queue is a tournament. A match has four players and fits in one cache line. With n spheres, a change
/// updates at most ⌈log₄ n⌉ matches (D. Knuth, "The Art of Computer Programming" 3, 5.4.1).
class EventQueue {
 public:
  using Index = std::uint32_t;

  explicit EventQueue(std::size_t count = 0) {
    std::size_t players = std::max<std::size_t>(count, 1);
    do {
      players = (players + 3) / 4;
      rounds_.emplace_back(players);
    } while (players > 1);
    for (std::size_t round = 0; round < rounds_.size(); ++round) {
      for (std::size_t k = 0; k < rounds_[round].size(); ++k) {
        for (std::size_t place = 0; place < 4; ++place) {
          // Absent players never win: their times are `never`, and of equal times the lowest index is first.
          rounds_[round][k].players[place] = static_cast<Index>((4 * k + place) << (2 * round));
        }
      }
    }
  }

  void set(Index index, double time) {
    Index winner = index;
    std::size_t place = index;
    for (std::vector<Match>& round : rounds_) {
      Match& match = round[place / 4];
      double& old_time = match.times[place % 4];
      Index& old_winner = match.players[place % 4];
      if (old_time == time && old_winner == winner) {
        return;  // no later match changes
      }
      old_time = time;
      old_winner = winner;
      const std::size_t first = match.first();
      winner = match.players[first];
      time = match.times[first];
      place /= 4;
    }
  }

  [[nodiscard]] Index first() const {
    const Match& last = rounds_.back().front();
    return last.players[last.first()];
  }
  [[nodiscard]] double time_of(Index index) const { return rounds_.front()[index / 4].times[index % 4]; }

  /// Calls use(k) for each index k whose time is at most `latest` and not `never`, in ascending order.
  template <class Use>
  void for_each_until(double latest, const Use& use) const {
    visit(rounds_.size() - 1, 0, latest, use);
  }

  void prefetch(Index index) const { __builtin_prefetch(&rounds_.front()[index / 4]); }

  [[nodiscard]] std::size_t bytes() const {
    std::size_t matches = 0;
    for (const std::vector<Match>& round : rounds_) {
      matches += round.size();
    }
    return matches * sizeof(Match);
  }

 private:
  struct alignas(64) Match {
    std::array<double, 4> times{never, never, never, never};
    std::array<Index, 4> players{};

    [[nodiscard]] std::size_t first() const {
      const std::size_t left = times[1] < times[0] ? 1 : 0;
      const std::size_t right = times[3] < times[2] ? 3 : 2;
      return times[right] < times[left] ? right : left;
    }
  };

  template <class Use>
  void visit(std::size_t round, std::size_t k, double latest, const Use& use) const {
    for (std::size_t place = 0; place < 4; ++place) {
      const Match& match = rounds_[round][k];
      if (match.times[place] > latest || match.times[place] == never) {
        continue;
      }
      if (round == 0) {
        use(match.players[place]);
      } else {
        visit(round - 1, 4 * k + place, latest, use);
      }
    }
  }

  std::vector<std::vector<Match>> rounds_;  // the winner of match k plays in match k/4 of the next round
};

}  // namespace carom::scene
