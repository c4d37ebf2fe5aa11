// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <string>
#include <vector>

#include <carom/properties/features/infeasible.hpp>

namespace carom::properties {
namespace {

constexpr int none = 100;  // decades that no quantity has

/// Patterns of names: "X." stands for a body, the same one in both, "Y." for the other one; at the end * for anything.
struct Exclusion {
  std::string_view x;
  std::vector<std::string_view> y;
  std::string_view why;
};

/// A feature says in which decades a quantity is: from `low` to `high`.
struct Bound {
  std::string_view feature;
  std::string_view quantity;
  int low;
  int high;
  std::string_view why;
};

const std::vector<std::vector<std::string_view>>& one_of_these() {
  static const std::vector<std::vector<std::string_view>> groups{
      {"X.orientation_identity", "X.orientation_long_identity", "X.orientation_negated_identity",
       "X.orientation_half_turn", "X.orientation_half_turn_about_axis", "X.orientation_quarter_turn",
       "X.orientation_about_axis"},
      {"X.orientation_identity", "X.orientation_long_identity", "X.orientation_half_turn",
       "X.orientation_half_turn_about_axis", "X.orientation_negative"},
      {"X.orientation_identity", "X.orientation_long_identity", "X.orientation_negated_identity", "X.orientation_unit"},
      {"X.mass_one", "X.mass_power_of_two"},
      {"X.moments_equal", "X.moments_two_equal", "X.moments_ascending", "X.moments_descending"},
      {"X.moments_one", "X.moments_two_equal", "X.moments_ascending", "X.moments_descending"},
      {"X.lever_arm_zero", "X.lever_arm_along_axis", "X.lever_arm_in_plane"},
      {"X.lever_arm_zero", "X.lever_arm_along_normal", "X.lever_arm_across_normal"},
      {"X.velocity_zero", "X.velocity_along_axis", "X.velocity_in_plane"},
      {"X.velocity_zero", "X.velocity_along_axis", "X.velocity_ties"},
      {"X.velocity_zero", "X.velocity_along_normal", "X.velocity_across_normal"},
      {"X.spin_zero", "X.spin_along_normal", "X.spin_across_normal"},
      {"normal_plus_*", "normal_minus_*", "normal_near_*", "normal_diagonal"},
      {"normal_plus_*", "normal_minus_*", "normal_in_plane", "normal_diagonal"},
      {"normal_plus_*", "normal_minus_*", "normal_ties", "normal_diagonal"},
      {"normal_plus_*", "normal_minus_*", "normal_unit"},
      {"normal_unit", "normal_long", "normal_very_long", "normal_short", "normal_very_short"},
      {"restitution_zero", "restitution_one", "restitution_half"},
      {"restitution_zero", "restitution_one", "restitution_equals_friction"},
      {"friction_zero", "friction_some", "friction_one", "friction_great"},
      {"friction_zero", "friction_one", "friction_great", "restitution_equals_friction"},
      {"tangential_restitution_zero", "tangential_restitution_positive", "tangential_restitution_negative",
       "tangential_restitution_one", "tangential_restitution_minus_one"},
      {"orientations_equal", "orientations_opposite"},
      {"velocities_equal", "velocities_opposite"},
      {"velocities_equal", "momenta_opposite"},
      {"spins_equal", "spins_opposite"},
      {"lever_arms_opposite", "centres_coincide"},
      {"head_on", "near_head_on", "grazing"},
  };
  return groups;
}

const std::vector<Exclusion>& exclusions() {
  static const std::vector<Exclusion> all{
      {"X.immovable",
       {"X.orientation_*", "X.mass_one", "X.mass_power_of_two", "X.moments_*", "X.flat", "masses_equal",
        "moments_alike", "bodies_alike", "orientations_*", "momenta_opposite"},
       "an immovable body has neither mass nor moments nor orientation"},
      {"X.immovable", {"Y.immovable"}, "of two immovable bodies none is struck"},
      {"X.moments_equal", {"X.flat"}, "of three equal moments none is the sum of the others"},
      {"X.moments_one", {"X.flat"}, "of three equal moments none is the sum of the others"},
      {"X.lever_arm_zero",
       {"X.lever_arm_along_velocity", "X.spin_along_lever_arm", "X.rolling", "lever_arms_opposite", "centres_coincide",
        "central"},
       "a lever arm of zero has no direction, and spin moves nothing there"},
      {"X.lever_arm_across_normal", {"central"}, "central lever arms lie along the normal"},
      {"X.velocity_zero",
       {"X.lever_arm_along_velocity", "X.spin_along_velocity", "X.spin_equals_velocity", "X.rolling", "velocities_*",
        "momenta_opposite"},
       "a velocity of zero has no direction"},
      {"X.spin_zero",
       {"X.spin_along_axis", "X.spin_along_lever_arm", "X.spin_along_velocity", "X.spin_equals_velocity", "X.rolling",
        "spins_*"},
       "a spin of zero has no direction"},
      {"X.at_rest",
       {"X.velocity_along_*", "X.velocity_in_plane", "X.velocity_ties", "X.velocity_across_normal",
        "X.lever_arm_along_velocity", "X.spin_along_*", "X.spin_across_normal", "X.spin_equals_velocity", "X.rolling",
        "velocities_*", "spins_*", "momenta_opposite"},
       "a body at rest has neither velocity nor spin"},
      {"X.at_rest", {"Y.at_rest"}, "where nothing moves nothing collides"},
      {"X.rolling",
       {"X.spin_along_lever_arm", "X.spin_along_velocity", "X.spin_equals_velocity", "X.lever_arm_along_velocity"},
       "v = r × w is orthogonal to both, and zero where they are parallel"},
      {"approach_by_spin",
       {"X.velocity_along_*", "X.velocity_in_plane", "X.velocity_ties", "X.velocity_across_normal",
        "X.lever_arm_along_velocity", "X.spin_along_velocity", "X.spin_equals_velocity", "X.rolling", "velocities_*",
        "momenta_opposite"},
       "both velocities are zero"},
      {"central",
       {"velocities_equal", "approach_by_spin"},
       "where lever arms lie along the normal spins approach nothing"},
      {"planar",
       {"normal_plus_z", "normal_minus_z", "normal_near_plus_z", "normal_near_minus_z", "normal_diagonal",
        "X.orientation_half_turn", "X.spin_along_normal", "X.spin_along_lever_arm", "X.spin_along_velocity",
        "X.spin_equals_velocity"},
       "in a plane all spins and turns are about z, and all else has no part along z"},
      {"whole_numbers",
       {"normal_unit", "normal_short", "normal_very_short", "restitution_half", "friction_some",
        "tangential_restitution_positive", "tangential_restitution_negative", "restitution_equals_friction"},
       "between 0 and 1 there is no whole number"},
  };
  return all;
}

const std::vector<Bound>& bounds() {
  constexpr std::string_view is_zero = "what is zero is in no decade";
  constexpr std::string_view has_none = "an immovable body has neither mass nor moments";
  constexpr std::string_view equal = "the ratio is 1";
  constexpr std::string_view whole = "a whole number is 0, or 1 and more";
  constexpr std::string_view in_domain = "masses are 10⁻⁹ to 10¹⁰ kg";
  constexpr std::string_view itself = "it is that very number";
  static const std::vector<Bound> all{
      {"X.velocity_zero", "X.speed", none, none, is_zero},
      {"X.at_rest", "X.speed", none, none, is_zero},
      {"X.at_rest", "X.spin", none, none, is_zero},
      {"X.spin_zero", "X.spin", none, none, is_zero},
      {"X.lever_arm_zero", "X.lever_arm", none, none, is_zero},
      {"approach_by_spin", "X.speed", none, none, is_zero},
      {"point_at_origin", "distance", none, none, is_zero},
      {"X.immovable", "X.mass", none, none, has_none},
      {"X.immovable", "X.size", none, none, has_none},
      {"X.immovable", "mass_ratio", none, none, has_none},
      {"X.immovable", "size_ratio", none, none, has_none},
      {"X.mass_one", "X.mass", 0, 0, itself},
      {"X.immovable", "X.moment_ratio", none, none, has_none},
      {"X.moments_equal", "X.moment_ratio", 0, 0, equal},
      {"X.moments_one", "X.moment_ratio", 0, 0, equal},
      {"X.moments_one", "X.size", -5, 4, in_domain},
      {"X.moments_one", "X.lever_arm", -none, 4, in_domain},
      {"whole_numbers", "X.size", -5, none, in_domain},
      {"masses_equal", "mass_ratio", 0, 0, equal},
      {"bodies_alike", "mass_ratio", 0, 0, equal},
      {"bodies_alike", "size_ratio", 0, 0, equal},
      {"restitution_zero", "restitution", none, none, itself},
      {"restitution_zero", "loss", none, none, "1 − ε is 1"},
      {"restitution_one", "restitution", none, none, itself},
      {"restitution_one", "loss", none, none, is_zero},
      {"restitution_half", "restitution", -1, -1, itself},
      {"restitution_half", "loss", -1, -1, itself},
      {"whole_numbers", "restitution", none, none, whole},
      {"whole_numbers", "loss", none, none, whole},
      {"whole_numbers", "X.mass", 0, none, whole},
      {"whole_numbers", "X.lever_arm", 0, none, whole},
      {"whole_numbers", "X.speed", 0, none, whole},
      {"whole_numbers", "X.spin", 0, none, whole},
      {"whole_numbers", "distance", 0, none, whole},
  };
  return all;
}

/// Whether the pattern, with X as one body and Y as the other, is the name; "…*" is every name that begins so. So many
/// pairs of features are held against all patterns that nothing is allocated.
bool matches(std::string_view name, std::string_view pattern, char letter) {
  if (pattern.starts_with("X.") || pattern.starts_with("Y.")) {
    const char other = letter == 'a' ? 'b' : 'a';
    if (name.empty() || name[0] != (pattern[0] == 'X' ? letter : other)) {
      return false;
    }
    name.remove_prefix(1);
    pattern.remove_prefix(1);
  }
  return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1)) : name == pattern;
}

std::string_view why_of_magnitudes(const Feature& x, const Feature& y) {
  if (x.quantity == y.quantity) {
    return "a quantity is in one decade";
  }
  if (x.quantity == "restitution" && y.quantity == "loss" && x.decade < -1 && y.decade < -1) {
    return "ε and 1 − ε are not both below 0.1";
  }
  const bool same_body = x.quantity.substr(0, 2) == y.quantity.substr(0, 2);
  if (same_body && x.quantity.ends_with(".size") && y.quantity.ends_with(".lever_arm") && y.decade > x.decade + 1) {
    return "the contact would lie outside of the body, where K has no bound";
  }
  return {};
}

std::string_view why_in_order(const Feature& x, const Feature& y) {
  if (x.kind == FeatureKind::magnitude) {
    return y.kind == FeatureKind::magnitude ? why_of_magnitudes(x, y) : std::string_view();
  }
  for (const char letter : {'a', 'b'}) {
    if (y.kind == FeatureKind::magnitude) {
      for (const Bound& bound : bounds()) {
        if (matches(x.name, bound.feature, letter) && matches(y.quantity, bound.quantity, letter) &&
            (y.decade < bound.low || y.decade > bound.high)) {
          return bound.why;
        }
      }
      continue;
    }
    for (const Exclusion& exclusion : exclusions()) {
      for (const std::string_view pattern : exclusion.y) {
        if (matches(x.name, exclusion.x, letter) && matches(y.name, pattern, letter)) {
          return exclusion.why;
        }
      }
    }
    for (const std::vector<std::string_view>& group : one_of_these()) {
      const auto is_in = [&](const Feature& feature) {
        return std::any_of(group.begin(), group.end(),
                           [&](std::string_view pattern) { return matches(feature.name, pattern, letter); });
      };
      if (is_in(x) && is_in(y)) {
        return "one of them at most";
      }
    }
  }
  return {};
}

}  // namespace

std::string_view why_infeasible(const Feature& x, const Feature& y) {
  const std::string_view why = why_in_order(x, y);
  return why.empty() ? why_in_order(y, x) : why;
}

}  // namespace carom::properties
