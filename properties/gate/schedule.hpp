// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

/// The cases of one family from `first` to `last` − 1, which a subject gets at once.
struct Task {
  std::uint64_t number = 0;  // in the schedule, from 0
  std::size_t family = 0;    // place in the options
  std::uint64_t first = 0;   // in the order of the family's cases in the shard
  std::uint64_t last = 0;
  Shard shard = {};

  /// The number, in its family, of the task's `i`-th case. Both count from 0.
  [[nodiscard]] std::uint64_t case_number(std::uint64_t i) const { return shard.case_number(first + i); }
};

/// The order of the cases in a run, the same for any number of threads. The families take turns by `Family::turn`. A
/// turn has one case (times the family's weight) in the first round, and twice as many in each further round. So the
/// first cases show a widespread defect. Threads may share a schedule.
class Schedule {
 public:
  explicit Schedule(const GateOptions& options);

  /// The next task; none if all cases were handed out. With a budget, there is always one.
  [[nodiscard]] std::optional<Task> next();

 private:
  struct Place {
    std::size_t family;
    std::uint64_t weight;
    std::uint64_t cases;         // in all
    std::uint64_t drawn = 0;     // cases handed out so far
    std::uint64_t turn_end = 0;  // `drawn` at the end of its turn
  };

  void start_turn();

  std::mutex mutex_;
  Shard shard_;
  std::vector<Place> places_;  // in the order of the turns
  std::size_t turn_ = 0;       // place of the family whose turn it is
  std::uint64_t cases_in_turn_ = 1;
  std::uint64_t next_number_ = 0;
};

}  // namespace carom::properties
