// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/cases/family.hpp>

/// Wild cases: collisions that no family draws.
namespace carom::equality {

/// The case with its numbers rounded to 1 to 12 binary digits and clamped to sizes of 2⁻⁷ to 2⁶. Body B is immovable at
/// least half of the time. Rational arithmetic is quick on such a case, and exact coincidences occur.
[[nodiscard]] properties::Case shortened(properties::Case one, properties::Stream& stream);

/// A valid collision. Either each field of a family's case is scaled by its own power of two, up to 2^±k, or the
/// numbers are random, with exponents up to ±k. Usually k ≤ 40. In about one case in 64, k is 100 to 1000, or the
/// numbers are random bit patterns.
[[nodiscard]] properties::Case wild_case(properties::Stream& stream);

}  // namespace carom::equality
