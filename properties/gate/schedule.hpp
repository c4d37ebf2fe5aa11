// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include <carom/properties/gate/gate_result.hpp>

namespace carom::properties {

/// Cases of one family, from `first` to before `last`, that are put to a subject at once.
struct Task {
  std::uint64_t number = 0;  // in the schedule, from 0
  std::size_t family = 0;    // of the options
  std::uint64_t first = 0;   // in the order of the family's cases, of a shard those that it has
  std::uint64_t last = 0;
  Shard shard = {};

  /// The number in its family of the task's `i`-th case.
  [[nodiscard]] std::uint64_t case_number(std::uint64_t i) const { return shard.case_number(first + i); }
};

/// In which order the cases of a run are put: the families in turn, those first that find most defects soonest, in
/// turns that double from one case (times the family's weight), so that a defect that shows everywhere is met at once.
/// Each case stands in one task, whatever the number of threads; these may share a schedule.
class Schedule {
 public:
  explicit Schedule(const GateOptions& options);

  /// None where all cases were given out; with a budget there are always more.
  [[nodiscard]] std::optional<Task> next();

 private:
  /// Of one family.
  struct Place {
    std::size_t family;
    std::uint64_t weight;
    std::uint64_t cases;         // in all
    std::uint64_t drawn = 0;     // given out
    std::uint64_t turn_end = 0;  // `drawn` at the end of its turn
  };

  void start_turn();

  std::mutex mutex_;
  Shard shard_;
  std::vector<Place> places_;  // in the order of turns
  std::size_t turn_ = 0;       // whose turn it is
  std::uint64_t cases_in_turn_ = 1;
  std::uint64_t next_number_ = 0;
};

}  // namespace carom::properties
