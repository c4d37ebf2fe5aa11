// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/diagnosis/hypothesis.hpp>

/// The groups of hypotheses, each in a file of its own.
namespace carom::properties::diagnosis {

/// The impulse is the law's, but its effect on the bodies is wrong.
[[nodiscard]] std::vector<Hypothesis> misused_impulses();
/// The solver misreads restitution, friction, the normal or the approach.
[[nodiscard]] std::vector<Hypothesis> misread_contacts();
/// The solver misreads lever arms, orientations, moments, masses or velocities.
[[nodiscard]] std::vector<Hypothesis> misread_bodies();
/// The solver gives the answer of another law.
[[nodiscard]] std::vector<Hypothesis> other_laws();

/// The law's change of the velocities for the changed collision, added to the velocities of the case. No value if the
/// changed collision is invalid.
[[nodiscard]] std::optional<Outcome<double>> answer_to(const Collision& changed, const KnownCase& one);

/// The law's impulse for the changed collision, applied to the unchanged bodies. No value if the changed collision is
/// invalid.
[[nodiscard]] std::optional<Outcome<double>> impulse_of(const Collision& changed, const KnownCase& one);

}  // namespace carom::properties::diagnosis
