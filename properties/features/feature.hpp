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
/// fields, magnitudes. Faults show in them, because code branches on them.
namespace carom::properties {

enum class FeatureKind { special_value, relation, magnitude };

[[nodiscard]] std::string_view name_of(FeatureKind kind);

/// A pattern for names of features. "X." stands for the body that the feature belongs to, or for either body if it
/// belongs to none. "Y." stands for the other body. "…*" matches every name with this beginning.
using NamePattern = std::string_view;

/// Features that no colliding contact of real bodies has together with a given one.
struct Exclusion {
  std::vector<NamePattern> features;
  std::string_view why;
};

/// The only decades, from `low` to `high`, in which a quantity with a matching name can be together with a given
/// feature.
struct Decades {
  NamePattern quantity;
  int low;
  int high;
  std::string_view why;
};
inline constexpr int no_decade = 100;  // a decade that no quantity has

/// The limits that a feature sets for others.
struct Limits {
  /// Groups that the feature belongs to. A collision, or a body of it, has at most one feature of a group.
  std::vector<std::string_view> kinds_of = {};
  std::vector<Exclusion> never_with = {};
  std::vector<Decades> only_in = {};
};

/// The way to draw the decade of a magnitude.
enum class DrawnBy { itself, size_of_body, lever_arm };

/// A named predicate of a valid collision, and its properties. It is decided in binary64, as in a solver's guard:
/// "parallel" and "equal" mean so after rounding.
struct Feature {
  std::string name;  // "a.orientation_identity", "masses_equal", "b.mass_1e-9"
  FeatureKind kind;
  std::string statement;  // the predicate in words
  std::string why;        // the reason for the feature: a failure case, a guard in code, a fast path
  /// For a magnitude: the quantity and its decade, 10^decade ≤ quantity < 10^(decade + 1).
  std::string quantity = {};
  int decade = 0;
  std::function<bool(const Collision&)> is_present;
  /// Changes a valid collision so that the feature is present, if that is possible. It changes as little else as
  /// possible.
  std::function<void(Stream&, Collision&)> make;
  Limits limits = {};
  char body = 0;                 // 'a' or 'b' for a feature of one body, whose name starts with it
  bool makes_immovable = false;  // `sprinkle` leaves such features out, because the family decides which body can move
  // For a magnitude:
  int set_once_in = 1;  // set in one case of this many: a quantity that follows from others is not always set
  bool is_seldom_with_others = false;  // unless it is chosen for it, as relations are
  DrawnBy drawn_by = DrawnBy::itself;
};

/// Every feature, in the order in which they are listed.
[[nodiscard]] std::span<const Feature> all_features();

/// The feature with this name; nullptr if there is none.
[[nodiscard]] const Feature* feature_named(std::string_view name);

}  // namespace carom::properties
