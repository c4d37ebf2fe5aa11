// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include <carom/collision/collision.hpp>
#include <carom/properties/families/stream.hpp>

/// What scenes are made of and random numbers are not: special values, relations between fields, sizes. Faults live in
/// these, since they are what code branches on.
namespace carom::properties {

enum class FeatureKind { special_value, relation, magnitude };

[[nodiscard]] std::string_view name_of(FeatureKind kind);

/// A named predicate of a valid collision. It is decided in binary64, as a solver's guard would decide it: what is
/// parallel, or equal, is so as rounded.
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
};

/// Every feature, in the order in which they are listed.
[[nodiscard]] std::span<const Feature> all_features();

/// The feature of this name; nullptr where there is none.
[[nodiscard]] const Feature* feature_named(std::string_view name);

}  // namespace carom::properties
