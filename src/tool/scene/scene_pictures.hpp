// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <carom/report/drawing/plot.hpp>

#include "scene/series.hpp"

namespace carom::tool {

/// What a picture shows of one run.
struct SampledLaw {
  std::string law;
  std::vector<Sample> samples;
};

/// Energy over time: of one law its parts and what is lost, of several the whole of each.
[[nodiscard]] report::Plot energy_picture(std::span<const SampledLaw> laws);
/// The components of the momentum, or of several laws its size.
[[nodiscard]] report::Plot momentum_picture(std::span<const SampledLaw> laws);
/// Energy of rotation.
[[nodiscard]] report::Plot spin_picture(std::span<const SampledLaw> laws);

}  // namespace carom::tool
