// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include <carom/collision/enum_array.hpp>
#include <carom/oracles/judge/exact_case.hpp>

/// Finds the contacts on which a lesser (cheaper) law equals the law asked for.
namespace carom::properties::plan {

enum class Reduction {
  same_law,
  untouched,    // the contact does not collide: every law keeps the velocities
  eigenvector,  // N × K N = 0
  no_friction,  // μ = 0
  no_share,     // e_t = −1: the factor 1 + e_t of friction in `rough` is 0
  no_slip,      // no slip is left after the frictionless impulse
  sticks,       // friction stops the contact point, inside the friction cone
  isotropic,    // N is an eigenvector, K is a multiple of the identity across N, and e_t = 0
};
inline constexpr std::array all_reductions{Reduction::same_law,    Reduction::untouched, Reduction::eigenvector,
                                           Reduction::no_friction, Reduction::no_share,  Reduction::no_slip,
                                           Reduction::sticks,      Reduction::isotropic};
static_assert(counts_from_zero_to(all_reductions, Reduction::isotropic));

/// For example "N is an eigenvector of K".
[[nodiscard]] std::string_view in_words(Reduction reduction);

/// The laws that may replace this law, from the cheapest to the law itself. Empty for `any`.
[[nodiscard]] std::span<const Law> lesser_laws(Law law);

/// Whether N × K N = 0 exactly. Reflection then equals frictionless for all velocities. Precondition: a body is
/// movable.
[[nodiscard]] bool is_normal_eigenvector(const oracles::ExactCase& exact_case);

/// Why the lesser law's outcome is exactly an outcome of the law; none if it is not. Decided in ℚ. Precondition:
/// `lesser` is one of `lesser_laws(law)`.
[[nodiscard]] std::optional<Reduction> reduction(const oracles::ExactCase& exact_case, Law law, Law lesser);

}  // namespace carom::properties::plan
