// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/gate/trial.hpp>

/// Planted outcomes, whose errors are near the permitted errors.
namespace carom::equality {

/// The exact outcome rounded to the precision, with one vector moved. In half of the cases, the backward error is ½ to
/// 2 times the limit. In the other half, another factor from 2⁻⁵ to 2⁶ multiplies this error, because invariants have
/// different limits. Preconditions: the case is valid; the law is not `any`.
[[nodiscard]] ReportedOutcome planted_outcome(const oracles::ExactCase& exact_case, Law law, Precision precision,
                                              double allowance, properties::Stream& stream);

/// A solver that answers with planted outcomes, which depend only on the collision's numbers. It refuses invalid
/// collisions.
[[nodiscard]] Subject planting_subject(Law law, Precision precision);

}  // namespace carom::equality
