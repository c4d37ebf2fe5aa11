// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/trial/trial.hpp>

/// Outcomes at the edge of what is allowed.
namespace carom::equality {

/// The exact outcome rounded to the precision, with one vector moved so far that one invariant comes near its bound:
/// either backward_error itself, ½ to 2 times the limit, or, since laws allow more, up to 2⁶ times that.
/// Preconditions: the case is valid; the model is `coulomb` or determines the outcome.
[[nodiscard]] ReportedOutcome planted_outcome(const oracles::ExactCase& exact_case, Model model, Precision precision,
                                              double allowance, properties::Stream& stream);

/// A solver that answers every collision so; what it plants follows from the collision's numbers alone. Valid
/// collisions only.
[[nodiscard]] Subject planting_subject(Model model, Precision precision);

}  // namespace carom::equality
