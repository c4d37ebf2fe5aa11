// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/stepper.hpp>

namespace carom::tool {

/// The simulation of `carom scene` as an engine that steps, so that the phenomena can judge it.
[[nodiscard]] Stepper scene_stepper();

}  // namespace carom::tool
