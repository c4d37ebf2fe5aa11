// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include <carom/collision/enum_array.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/judge/yardstick.hpp>

namespace carom::properties {

/// The reason why a valid collision is not judged. No case is left out because it is hard.
enum class Unjudged {
  leaves_range,         // numbers leave the range of the subject's precision
  no_finite_enclosure,  // the law's outcomes over the permitted inputs have no finite bounds (oracles::PermittedInputs)
  at_declared_limit,    // rounding decides whether the subject's declared threshold or slop applies
};
inline constexpr std::array all_reasons_unjudged{Unjudged::leaves_range, Unjudged::no_finite_enclosure,
                                                 Unjudged::at_declared_limit};
static_assert(counts_from_zero_to(all_reasons_unjudged, Unjudged::at_declared_limit));

using UnjudgedCounts = EnumArray<Unjudged, std::uint64_t, all_reasons_unjudged.size()>;

[[nodiscard]] std::string_view name_of(Unjudged reason);

/// The end of a sentence: "… whose masses, moments, impulse or torque leave the range of the precision".
[[nodiscard]] std::string_view in_words(Unjudged reason);

/// The reason why the yardstick does not judge a collision; no value if it does. In binary32, the numbers that a law
/// computes for the contact (masses, moments, impulse, torque) must be zero, or between 2⁵ times the least normal
/// number and 2⁻⁸ times the largest number.
[[nodiscard]] std::optional<Unjudged> reason_unjudged(const oracles::ExactCase& exact_case,
                                                      const oracles::Yardstick& yardstick);

}  // namespace carom::properties
