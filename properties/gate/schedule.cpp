// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/properties/gate/schedule.hpp>

namespace carom::properties {
namespace {

constexpr std::uint64_t most_cases_in_task = 50;

}  // namespace

Schedule::Schedule(const GateOptions& options) : shard_(options.shard) {
  for (std::size_t family = 0; family < options.families.size(); ++family) {
    places_.push_back({family, static_cast<std::uint64_t>(options.families[family]->weight),
                       cases_of(options, *options.families[family])});
  }
  std::stable_sort(places_.begin(), places_.end(), [&](const Place& x, const Place& y) {
    return options.families[x.family]->turn < options.families[y.family]->turn;
  });
  if (!places_.empty()) {
    start_turn();
  }
}

void Schedule::start_turn() {
  Place& place = places_[turn_];
  place.turn_end = std::min(place.drawn + cases_in_turn_ * place.weight, place.cases);
}

std::optional<Task> Schedule::next() {
  const std::lock_guard lock(mutex_);
  const auto is_done = [](const Place& place) { return place.drawn == place.cases; };
  if (std::all_of(places_.begin(), places_.end(), is_done)) {
    return std::nullopt;
  }
  while (places_[turn_].drawn == places_[turn_].turn_end) {
    if (++turn_ == places_.size()) {
      turn_ = 0;
      cases_in_turn_ = std::min(2 * cases_in_turn_, most_cases_in_task);
    }
    start_turn();
  }
  Place& place = places_[turn_];
  const std::uint64_t first = place.drawn;
  place.drawn = std::min(first + most_cases_in_task, place.turn_end);
  return Task{next_number_++, place.family, first, place.drawn, shard_};
}

}  // namespace carom::properties
