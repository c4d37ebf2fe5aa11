// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "report/overall.hpp"

namespace carom::tool {

/// "carom | sound" and the like as a picture, in SVG, that refers to nothing else.
[[nodiscard]] std::string badge_svg(const Overall& overall);

}  // namespace carom::tool
