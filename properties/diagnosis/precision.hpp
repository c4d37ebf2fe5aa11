// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/oracles/truths/sensitivity.hpp>
#include <carom/properties/draws/general_collision.hpp>

namespace carom::properties::diagnosis {

/// The scalar of the diagnosis. Its range holds the squares of all binary64 numbers. It is slow, above all in
/// WebAssembly, which computes it in software.
using Wide = long double;

/// Whether binary64 suffices: no number is extreme, and no body is slender. Then the rounding is far below the least
/// share of an error that `is_explained_by` tells apart.
template <class... Outcomes>
bool is_plain(const Collision& collision, const Outcomes&... outcomes) {
  // Products of four such numbers, and of their differences, neither overflow nor underflow. The exponent alone
  // decides, without branches, because each trial answer of a search is looked at.
  const auto is_in_middle = [](double x) {
    constexpr std::uint64_t all_exponents = 0x7ff;
    constexpr std::uint64_t least = 1023 - 100;  // of 2⁻¹⁰⁰, in the format of binary64
    constexpr std::uint64_t greatest = 1023 + 100;
    const std::uint64_t exponent = (std::bit_cast<std::uint64_t>(x) >> 52U) & all_exponents;
    return (x == 0) | (exponent - least <= greatest - least);
  };
  constexpr double slender = 8;
  bool plain = moment_ratio(collision.a) <= slender && moment_ratio(collision.b) <= slender;
  for_each_number([&](const FieldPath&, double x) { plain &= is_in_middle(x); }, collision);
  [[maybe_unused]] const auto look_at = [&](const Outcome<double>& outcome) {
    for (const Vector3<double>* v : vectors(outcome)) {
      for (const double x : *v) {
        plain &= is_in_middle(x);
      }
    }
  };
  (look_at(outcomes), ...);
  return plain;
}

/// use(S{}), with S as narrow as the numbers permit.
template <class Use, class... Outcomes>
auto in_sufficient_precision(const Use& use, const Collision& collision, const Outcomes&... outcomes) {
  return is_plain(collision, outcomes...) ? use(double{}) : use(Wide{});
}

/// The growth of rounding errors up to which an impulse in extended precision, with the unit roundoff u, has a relative
/// error below 2⁹ u · 2²⁰ ≤ 2⁻³⁵. Errors below 2⁻³³ are not visible.
inline constexpr double most_growth_in_wide = 0x1p20;

/// Whether binary64 computes an impulse with such an error: 2⁹ · 2⁻⁵³ · 2⁹. Precondition: a body is movable.
inline bool suffices_binary64(const Collision& collision) {
  constexpr double most_growth = 0x1p9;
  return is_plain(collision) && oracles::growth_in_collision_matrix(collision) <= most_growth;
}

}  // namespace carom::properties::diagnosis
