// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/gate/workers.hpp>

namespace carom::tool {

/// Runs work on `jobs` threads, including the caller's, or on one for each core if `jobs` is 0. If the system cannot
/// start all threads, the started ones do all the work.
[[nodiscard]] properties::Workers threads(unsigned jobs);

}  // namespace carom::tool
