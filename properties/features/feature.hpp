// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/stream.hpp>

/// Features are special values, relations between fields, values that are nearly special, and magnitudes. They are
/// common in scenes and rare in random numbers. Solvers branch on them, so faults show there.
namespace carom::properties {

enum class FeatureKind { special_value, relation, near, magnitude };

[[nodiscard]] std::string_view name_of(FeatureKind kind);

/// The statement of a near feature is this and the special statement: "it nearly holds that both masses are equal".
inline constexpr std::string_view nearly = "it nearly holds that ";

/// The way to draw the decade of a magnitude.
enum class DrawnBy { itself, size_of_body, lever_arm };

/// A named predicate of a valid collision. It is decided in binary64, as in a solver's guard, so "parallel" and "equal"
/// refer to rounded numbers.
struct Feature {
  std::string name;  // "a.orientation_identity", "masses_equal", "b.mass_1e-9"
  FeatureKind kind;
  std::string statement;  // the predicate in words
  std::string why;        // a failure case, a guard in code, a fast path
  /// For a magnitude: the quantity and its decade, 10^decade ≤ quantity < 10^(decade + 1).
  std::string quantity = {};
  int decade = 0;
  std::function<bool(const Collision&)> is_present;
  /// Gives a valid collision the feature, if possible, and changes as little else as possible.
  std::function<void(Stream&, Collision&)> make;
  char body = 0;                 // 'a' or 'b' for a feature of one body, whose name starts with the letter
  bool makes_immovable = false;  // `sprinkle` leaves such features out, because the family decides which body can move
  /// The quantity of a magnitude; 0 if the collision does not have it. The relative distance of a near feature.
  std::function<double(const Collision&)> measure = {};
  // For a magnitude:
  /// `structured_collision` sets the quantity with the probability 1 / set_once_in. Otherwise other draws determine the
  /// quantity.
  int set_once_in = 1;
  bool is_seldom_with_others = false;  // seldom occurs with another feature unless both are chosen
  DrawnBy drawn_by = DrawnBy::itself;
};

[[nodiscard]] std::span<const Feature> all_features();

/// nullptr if no feature has this name.
[[nodiscard]] const Feature* feature_named(std::string_view name);

}  // namespace carom::properties
