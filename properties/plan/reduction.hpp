// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include <carom/collision/enum_array.hpp>
#include <carom/oracles/judge/exact_case.hpp>

/// Where a lesser law is the law that was asked for.
namespace carom::properties::plan {

/// Why two laws answer a contact alike, exactly.
enum class Reduction {
  same_law,
  untouched,    // the contact does not collide: every law leaves the velocities
  eigenvector,  // N × K N = 0
  no_friction,  // μ = 0
  no_share,     // e_t = −1: `rough` has 1 + e_t as the most of its friction
  no_slip,      // the frictionless impulse ends with no slip by itself
  sticks,       // friction stops the contact point, inside its cone
  isotropic,    // K is a multiple of the identity across N, which is an eigenvector, and e_t = 0
};
inline constexpr std::array all_reductions{Reduction::same_law,    Reduction::untouched, Reduction::eigenvector,
                                           Reduction::no_friction, Reduction::no_share,  Reduction::no_slip,
                                           Reduction::sticks,      Reduction::isotropic};
static_assert(counts_from_zero_to(all_reductions, Reduction::isotropic));

/// The statement of it, "N is an eigenvector of K".
[[nodiscard]] std::string_view in_words(Reduction reduction);

/// The laws that may stand in for this one, the cheapest first, itself the last.
[[nodiscard]] std::span<const Model> lesser_laws(Model law);

/// Whether N × K N = 0, exactly: reflection is then frictionless, whatever the velocities.
/// Precondition: a body is movable.
[[nodiscard]] bool is_normal_eigenvector(const oracles::ExactCase& exact_case);

/// Why the outcome of the lesser law to this contact is, exactly, an outcome of the law; none where it is not. Decided
/// in ℚ. Precondition: `lesser` is one of `lesser_laws(law)`.
[[nodiscard]] std::optional<Reduction> reduction(const oracles::ExactCase& exact_case, Model law, Model lesser);

}  // namespace carom::properties::plan
