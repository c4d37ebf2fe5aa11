// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {

[[nodiscard]] std::vector<Hypothesis> misused_impulses();
[[nodiscard]] std::vector<Hypothesis> misread_contacts();
[[nodiscard]] std::vector<Hypothesis> misread_bodies();
[[nodiscard]] std::vector<Hypothesis> other_laws();

}  // namespace carom::properties::diagnosis
