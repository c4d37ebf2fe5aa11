// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/gate/trial.hpp>

/// Collisions that no family draws, and planted outcomes, whose errors are near the permitted errors.
namespace carom::equality {

/// The case with its numbers rounded to 1 to 12 binary digits and clamped to sizes of 2⁻⁷ to 2⁶. Body B is immovable at
/// least half of the time. Rational arithmetic is quick on such a case, and exact coincidences occur.
[[nodiscard]] properties::Case shortened(properties::Case one, properties::Stream& stream);

/// A valid collision. Either each field of a family's case is scaled by its own power of two, up to 2^±k, or the
/// numbers are random, with exponents up to ±k. Usually k ≤ 40. In about one case in 64, k is 100 to 1000, or the
/// numbers are random bit patterns.
[[nodiscard]] properties::Case wild_case(properties::Stream& stream);

/// The exact outcome rounded to the precision, with one vector moved. In half of the cases, the backward error is ½ to
/// 2 times the limit. In the other half, another factor from 2⁻⁵ to 2⁶ multiplies this error, because invariants have
/// different limits. Preconditions: the case is valid; the law is not `any`.
[[nodiscard]] ReportedOutcome planted_outcome(const oracles::ExactCase& exact_case, Law law, Precision precision,
                                              double allowance, properties::Stream& stream);

/// A solver that answers with planted outcomes, which depend only on the collision's numbers. It refuses invalid
/// collisions.
[[nodiscard]] Subject planting_subject(Law law, Precision precision);

}  // namespace carom::equality
