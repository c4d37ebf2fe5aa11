// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/stream.hpp>

/// What scenes are made of and random numbers are not: special values, relations between fields, sizes. Faults live in
/// these, since they are what code branches on.
namespace carom::properties {

enum class FeatureKind { special_value, relation, magnitude };

[[nodiscard]] std::string_view name_of(FeatureKind kind);

/// Names of features: "X." stands for the body that the feature is of, or for either where it is of none, "Y." for the
/// other body; "…*" for every name that begins so.
using NamePattern = std::string_view;

/// Features that no colliding contact of real bodies has beside another.
struct Exclusion {
  std::vector<NamePattern> features;
  std::string_view why;
};

/// The only decades that a quantity, whose name matches, is in beside a feature: from `low` to `high`.
struct Decades {
  NamePattern quantity;
  int low;
  int high;
  std::string_view why;
};
inline constexpr int no_decade = 100;  // that no quantity has

/// The limits that a feature sets to others.
struct Limits {
  /// The feature is one kind of each of these. A collision, or a body of it, has one kind at most.
  std::vector<std::string_view> kinds_of = {};
  std::vector<Exclusion> never_with = {};
  std::vector<Decades> only_in = {};
};

/// How the decade of a magnitude is drawn.
enum class DrawnBy { itself, size_of_body, lever_arm };

/// A named predicate of a valid collision, and all that is known of it. It is decided in binary64, as a solver's guard
/// would decide it: what is parallel, or equal, is so as rounded.
struct Feature {
  std::string name;  // "a.orientation_identity", "masses_equal", "b.mass_1e-9"
  FeatureKind kind;
  std::string statement;  // what holds where it is present
  std::string why;        // a failure case, a guard that code has, a fast path
  /// Of a magnitude: of which quantity, and in which decade: 10^decade ≤ quantity < 10^(decade + 1).
  std::string quantity = {};
  int decade = 0;
  std::function<bool(const Collision&)> is_present;
  /// Changes a valid collision so that the feature is present, or leaves it without where it cannot be. What else it
  /// changes is the least that is needed.
  std::function<void(Stream&, Collision&)> make;
  Limits limits = {};
  char body = 0;                 // 'a' or 'b' of a feature of one body, whose name begins so
  bool makes_immovable = false;  // whether a body can move is often for the family to say
  // Of a magnitude:
  int set_once_in = 1;                 // so many cases: a quantity that follows from others is not always set
  bool is_seldom_with_others = false;  // unless it is asked for, as relations are
  DrawnBy drawn_by = DrawnBy::itself;
};

/// Every feature, in the order in which they are listed.
[[nodiscard]] std::span<const Feature> all_features();

/// The feature of this name; nullptr where there is none.
[[nodiscard]] const Feature* feature_named(std::string_view name);

}  // namespace carom::properties
