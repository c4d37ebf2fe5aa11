// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <string_view>

#include <carom/properties/gate/schedule.hpp>

namespace carom::properties {
namespace {

constexpr std::uint64_t most_cases_in_task = 50;

/// Each family found most of the planted defects (tests/mutants) that those before it had left, by its first two cases
/// of eight seeds; those after `near_head_on` found none of these, and stand by how many they find
/// alone; the last two came later, and are unranked.
/// `first_violation --families` (tests/benchmarks) counts them anew.
constexpr std::array best_first{
    "structured",      "on_the_cone",   "both_immovable",    "driven_wall",
    "head_on",         "invalid",       "grazing",           "slow",
    "mass_ratio",      "near_head_on",  "sliding",           "zero_lever",
    "long_quaternion", "immovable_a",   "mass_scale",        "special_tangential_restitution",
    "sticking",        "immovable_b",   "fast_spin",         "great_friction",
    "far_from_origin", "generic",       "physical",          "elastic",
    "common_velocity", "long_normal",   "inelastic",         "near_collinear",
    "no_friction",     "spin_alone",    "collinear_spheres", "separating",
    "resting",         "stick_or_slip", "chung_ooi"};

std::size_t rank_of(std::string_view family) {
  return static_cast<std::size_t>(std::find(best_first.begin(), best_first.end(), family) - best_first.begin());
}

}  // namespace

Schedule::Schedule(const GateOptions& options) : shard_(options.shard) {
  for (std::size_t family = 0; family < options.families.size(); ++family) {
    places_.push_back({family, static_cast<std::uint64_t>(options.families[family]->weight),
                       cases_of(options, *options.families[family])});
  }
  std::stable_sort(places_.begin(), places_.end(), [&](const Place& x, const Place& y) {
    return rank_of(options.families[x.family]->name) < rank_of(options.families[y.family]->name);
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
