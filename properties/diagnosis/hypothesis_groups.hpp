// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {

[[nodiscard]] std::vector<Hypothesis> misused_impulses();
[[nodiscard]] std::vector<Hypothesis> misread_contacts();
[[nodiscard]] std::vector<Hypothesis> misread_bodies();
[[nodiscard]] std::vector<Hypothesis> other_laws();

/// The law's change of the velocities for the changed collision, added to the velocities of the case. No value if the
/// changed collision is invalid.
[[nodiscard]] std::optional<Outcome<double>> answer_to(const Collision& changed, const KnownCase& one);

/// The law's impulse for the changed collision, applied to the unchanged bodies. No value if the changed collision is
/// invalid.
[[nodiscard]] std::optional<Outcome<double>> impulse_of(const Collision& changed, const KnownCase& one);

}  // namespace carom::properties::diagnosis
