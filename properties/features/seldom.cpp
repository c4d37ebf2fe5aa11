// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <stdexcept>
#include <string>

#include <carom/properties/features/seldom.hpp>

namespace carom::properties {
namespace {

struct Beginnings {
  std::string_view first;
  std::string_view second;
};
constexpr std::array beginnings{
    Beginnings{"whole_numbers", "approach_1e-"},
    Beginnings{"whole_numbers", "normal_near_"},
    Beginnings{"whole_numbers", "a.size_1e-"},
    Beginnings{"whole_numbers", "b.size_1e-"},
    Beginnings{"whole_numbers", "near_head_on"},
    Beginnings{"whole_numbers", "a.orientation_"},
    Beginnings{"whole_numbers", "b.orientation_"},
    Beginnings{"lever_arms_opposite", "a.lever_arm_1e"},
    Beginnings{"lever_arms_opposite", "b.lever_arm_1e"},
    Beginnings{"grazing", "approach_1e"},
    Beginnings{"approach_1e", "a.speed_1e"},
    Beginnings{"approach_1e", "b.speed_1e"},
    Beginnings{"approach_1e", "a.lever_arm_1e"},
    Beginnings{"approach_1e", "b.lever_arm_1e"},
    Beginnings{"a.rolling", "velocities_"},
    Beginnings{"b.rolling", "velocities_"},
    Beginnings{"a.rolling", "momenta_"},
    Beginnings{"b.rolling", "momenta_"},
    Beginnings{"a.rolling", "approach_along_axis"},
    Beginnings{"b.rolling", "approach_along_axis"},
    Beginnings{"a.rolling", "whole_numbers"},
    Beginnings{"b.rolling", "whole_numbers"},
    Beginnings{"a.spin_equals_velocity", "head_on"},
    Beginnings{"b.spin_equals_velocity", "head_on"},
    Beginnings{"a.moments_one", "momenta_opposite"},
    Beginnings{"b.moments_one", "momenta_opposite"},
    Beginnings{"a.moments_one", "whole_numbers"},
    Beginnings{"b.moments_one", "whole_numbers"},
    Beginnings{"centres_coincide", "a.lever_arm_1e"},
    Beginnings{"centres_coincide", "b.lever_arm_1e"},
    Beginnings{"whole_numbers", "momenta_"},
    Beginnings{"whole_numbers", "velocities_"},
    Beginnings{"whole_numbers", "lever_arms_opposite"},
    Beginnings{"whole_numbers", "central"},
    Beginnings{"a.rolling", "b.rolling"},
    Beginnings{"a.rolling", "b.at_rest"},
    Beginnings{"a.at_rest", "b.rolling"},
    Beginnings{"moments_alike", "size_ratio_1e"},
    Beginnings{"normal_unit", "approach_1e"},
    Beginnings{"central", "velocities_"},
    Beginnings{"planar", "normal_near_"},
    Beginnings{"planar", "approach_1e"},
    Beginnings{"distance_1e", "a.lever_arm_1e"},
    Beginnings{"distance_1e", "b.lever_arm_1e"},
    Beginnings{"a.moments_one", "a.mass_"},
    Beginnings{"b.moments_one", "b.mass_"},
    Beginnings{"bodies_alike", "a.moment_ratio_1e"},
    Beginnings{"bodies_alike", "b.moment_ratio_1e"},
    Beginnings{"whole_numbers", "a.moment_ratio_1e"},
    Beginnings{"whole_numbers", "b.moment_ratio_1e"},
    Beginnings{"a.lever_arm_1e", "a.moment_ratio_1e"},
    Beginnings{"b.lever_arm_1e", "b.moment_ratio_1e"},
};

}  // namespace

std::vector<const Feature*> features_beginning(std::string_view beginning) {
  std::vector<const Feature*> features;
  for (const Feature& feature : all_features()) {
    if (feature.name.starts_with(beginning)) {
      features.push_back(&feature);
    }
  }
  if (features.empty()) {
    throw std::logic_error("no feature has a name that begins with \"" + std::string(beginning) + '"');
  }
  return features;
}

const std::vector<SeldomPair>& seldom_together() {
  static const std::vector<SeldomPair> pairs = [] {
    std::vector<SeldomPair> resolved;
    for (const Beginnings& names : beginnings) {
      resolved.push_back({features_beginning(names.first), features_beginning(names.second)});
    }
    return resolved;
  }();
  return pairs;
}

}  // namespace carom::properties
