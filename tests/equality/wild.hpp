// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// Collisions that no family draws.
namespace carom::equality {

/// The collision with each field scaled by its own power of two, from 2^−most to 2^most.
[[nodiscard]] Collision scaled_fields(Collision collision, int most, properties::Stream& stream);

/// The case with each number rounded to one to twelve binary digits, as the stream decides, and scaled to a size of
/// 2⁻⁷ to 2⁶. Body B is immovable at least half of the time. Rational arithmetic is quick on such a case, and exact
/// coincidences occur.
[[nodiscard]] properties::Case shortened(properties::Case one, properties::Stream& stream);

/// A valid collision of one of three kinds: a case of a family with each field scaled by its own power of two;
/// numbers with exponents up to ±k; random bit patterns. The scale is up to 2^±k, and k is drawn up to 1000. Zeros
/// and subnormal numbers occur. One case in 64 is extreme.
[[nodiscard]] properties::Case wild_case(properties::Stream& stream);

}  // namespace carom::equality
