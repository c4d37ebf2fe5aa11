// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <carom/report/drawing/plot.hpp>

#include "scene/scene_samples.hpp"

namespace carom::tool {

/// The data of one run for a picture.
struct SampledLaw {
  std::string law;
  std::vector<Sample> samples;
};

/// Energy over time [J]. One law: its parts and the lost energy. Several laws: the total of each law.
[[nodiscard]] report::Plot energy_plot(std::span<const SampledLaw> laws);
/// Momentum over time [N s]. One law: its components. Several laws: the magnitude of each law.
[[nodiscard]] report::Plot momentum_plot(std::span<const SampledLaw> laws);
/// The mean of ‖w‖ over the bodies [rad/s], for each law.
[[nodiscard]] report::Plot spin_plot(std::span<const SampledLaw> laws);

}  // namespace carom::tool
