// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/report/results/run.hpp>

namespace carom::tool {

[[nodiscard]] report::Environment this_environment();

}  // namespace carom::tool
