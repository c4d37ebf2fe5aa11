// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <carom/report/pictures/plot.hpp>

#include "scene/scene_run.hpp"

namespace carom::tool {

struct SampledLaw {
  std::string law;
  std::vector<Sample> samples;
};

/// Energy over time [J]. For one law: the parts of the energy, and the lost energy. For several laws: the total under
/// each law.
[[nodiscard]] report::Plot energy_plot(std::span<const SampledLaw> laws);
/// Momentum over time [N s]. For one law: the components. For several laws: the magnitude under each law.
[[nodiscard]] report::Plot momentum_plot(std::span<const SampledLaw> laws);
/// The mean of ‖w‖ over the bodies [rad/s], for each law.
[[nodiscard]] report::Plot spin_plot(std::span<const SampledLaw> laws);

}  // namespace carom::tool
