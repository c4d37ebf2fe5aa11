// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/stream.hpp>

/// Features are special values, relations between fields, and magnitudes. They are common in scenes and rare in random
/// numbers. Solvers branch on them, so faults show there.
namespace carom::properties {

enum class FeatureKind { special_value, relation, magnitude };

[[nodiscard]] std::string_view name_of(FeatureKind kind);

/// A pattern for names of features. "X." stands for the body of the feature that lists the pattern, or for either body
/// if that feature has none. "Y." stands for the other body. "*" at the end stands for any text.
using NamePattern = std::string_view;

/// Features that no colliding contact of real bodies has together with the feature that lists this exclusion.
struct Exclusion {
  std::vector<NamePattern> features;
  std::string_view why;
};

/// If a collision has the feature that lists this, each quantity whose name matches is in a decade from `low` to
/// `high`.
struct Decades {
  NamePattern quantity;
  int low;
  int high;
  std::string_view why;
};
inline constexpr int no_decade = 100;  // a decade that no quantity has

struct Limits {
  /// Groups. A collision, or one of its bodies, has at most one feature of each group.
  std::vector<std::string_view> kinds_of = {};
  std::vector<Exclusion> never_with = {};
  std::vector<Decades> only_in = {};
};

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
  Limits limits = {};
  char body = 0;                 // 'a' or 'b' for a feature of one body, whose name starts with the letter
  bool makes_immovable = false;  // `sprinkle` leaves such features out, because the family decides which body can move
  // For a magnitude:
  int set_once_in = 1;                 // set in one case of this many, because other quantities may determine it
  bool is_seldom_with_others = false;  // seldom occurs with another feature unless both are chosen
  DrawnBy drawn_by = DrawnBy::itself;
};

[[nodiscard]] std::span<const Feature> all_features();

/// nullptr if no feature has this name.
[[nodiscard]] const Feature* feature_named(std::string_view name);

}  // namespace carom::properties
