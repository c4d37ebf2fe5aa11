// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/diagnosis/hypothesis.hpp>

/// The groups that the hypotheses are put together from, a file each.
namespace carom::properties::diagnosis {

/// The impulse is the law's, and what is made of it is not.
[[nodiscard]] std::vector<Hypothesis> misused_impulses();
/// Restitution, friction, the normal, the approach.
[[nodiscard]] std::vector<Hypothesis> misread_contacts();
/// Lever arms, orientations, moments, masses, velocities.
[[nodiscard]] std::vector<Hypothesis> misread_bodies();
/// The answer of another law.
[[nodiscard]] std::vector<Hypothesis> other_laws();

/// What the law answers to the changed collision, as a change of velocities from those of the case; none where the
/// changed one is invalid.
[[nodiscard]] std::optional<Outcome<double>> answer_to(const Collision& changed, const KnownCase& one);

/// The law's impulse of the changed collision, put to the bodies as they are; none where the changed one is invalid.
[[nodiscard]] std::optional<Outcome<double>> impulse_of(const Collision& changed, const KnownCase& one);

}  // namespace carom::properties::diagnosis
