// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/report/model/run.hpp>

namespace carom::tool {

/// The environment of this program, on this machine, at this time.
[[nodiscard]] report::Environment this_environment();

}  // namespace carom::tool
