// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/phenomena/phenomena.hpp>

namespace carom::properties {

Ladder full_ladder() {
  return {{1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480, 1.0 / 960, 1.0 / 1920, 1.0 / 3840}, 24};
}

Ladder quick_ladder() { return {{1.0 / 60, 1.0 / 240}, 6}; }

std::span<const Phenomenon> all_phenomena() {
  static const std::vector<Phenomenon> all{bounce(), slow_bounce(),   slide(),        slide_to_roll(), stick(),
                                           spin(),   free_rotation(), flat_landing(), stack(),         pass_through()};
  return all;
}

std::vector<std::string> phenomenon_names() {
  std::vector<std::string> names;
  for (const Phenomenon& phenomenon : all_phenomena()) {
    names.emplace_back(phenomenon.name);
  }
  return names;
}

}  // namespace carom::properties
