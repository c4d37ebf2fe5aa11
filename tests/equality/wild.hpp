// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// Collisions that no family draws.
namespace carom::equality {

/// The collision with each field times its own power of two, from 2^−most to 2^most.
[[nodiscard]] Collision scaled_fields(Collision collision, int most, properties::Stream& stream);

/// The case with each number rounded to so many binary digits as the stream says, one to twelve, and brought to a size
/// of 2⁻⁷ to 2⁶, body B a wall every other time: rational arithmetic is quick on it, and exact coincidences come up.
[[nodiscard]] properties::Case shortened(properties::Case one, properties::Stream& stream);

/// A valid collision of one of three kinds: one of a family with each field scaled by its own power of two up to
/// 2^±k, k itself drawn up to 1000; numbers that are each of such an exponent; random bit patterns. Zeros and subnormal
/// numbers come up. One in 64 is extreme.
[[nodiscard]] properties::Case wild_case(properties::Stream& stream);

}  // namespace carom::equality
