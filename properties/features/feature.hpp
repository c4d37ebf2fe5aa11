// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/stream.hpp>

/// Features of collisions that are common in scenes and rare in random numbers: special values, relations between
/// fields, magnitudes. Faults of solvers show in these features, because code branches on them.
namespace carom::properties {

enum class FeatureKind { special_value, relation, magnitude };

[[nodiscard]] std::string_view name_of(FeatureKind kind);

/// A pattern for names of features. A feature lists patterns in its Limits. "X." stands for the body that this feature
/// belongs to, or for either body if it belongs to none. "Y." stands for the other body. "…*" matches every name with
/// this beginning.
using NamePattern = std::string_view;

/// Features that no colliding contact of real bodies has together with the feature that lists them.
struct Exclusion {
  std::vector<NamePattern> features;
  std::string_view why;
};

/// If a contact has the feature that lists this limit, each quantity with a matching name is in a decade from `low` to
/// `high`.
struct Decades {
  NamePattern quantity;
  int low;
  int high;
  std::string_view why;
};
inline constexpr int no_decade = 100;  // a decade that no quantity has

/// The limits that a feature sets for others.
struct Limits {
  /// Groups that the feature belongs to. A collision, or one of its bodies, has at most one feature of a group.
  std::vector<std::string_view> kinds_of = {};
  std::vector<Exclusion> never_with = {};
  std::vector<Decades> only_in = {};
};

/// The way to draw the decade of a magnitude.
enum class DrawnBy { itself, size_of_body, lever_arm };

/// A named predicate of a valid collision, and its properties. The predicate is decided in binary64, as in a solver's
/// guard. So "parallel" and "equal" refer to rounded numbers.
struct Feature {
  std::string name;  // "a.orientation_identity", "masses_equal", "b.mass_1e-9"
  FeatureKind kind;
  std::string statement;  // the predicate in words
  std::string why;        // the reason for the feature: a failure case, a guard in code, a fast path
  /// For a magnitude: the quantity and its decade, 10^decade ≤ quantity < 10^(decade + 1).
  std::string quantity = {};
  int decade = 0;
  std::function<bool(const Collision&)> is_present;
  /// Changes a valid collision so that the feature is present, if that is possible. `make` changes as little else as
  /// possible.
  std::function<void(Stream&, Collision&)> make;
  Limits limits = {};
  char body = 0;                 // 'a' or 'b' for a feature of one body, whose name starts with it
  bool makes_immovable = false;  // `sprinkle` leaves such features out, because the family decides which body can move
  // For a magnitude:
  int set_once_in = 1;                 // set in one case of this many, because other quantities may determine it
  bool is_seldom_with_others = false;  // unless both features are chosen, as for relations
  DrawnBy drawn_by = DrawnBy::itself;
};

/// Every feature, in the order in which they are listed.
[[nodiscard]] std::span<const Feature> all_features();

/// The feature with this name; nullptr if there is none.
[[nodiscard]] const Feature* feature_named(std::string_view name);

}  // namespace carom::properties
