// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/gate/workers.hpp>

namespace carom::tool {

/// So many threads, of which the caller's is one; one for each core if `jobs` is 0. If the system starts no more
/// threads, those that there are do all of the work.
[[nodiscard]] properties::Workers threads(unsigned jobs);

}  // namespace carom::tool
