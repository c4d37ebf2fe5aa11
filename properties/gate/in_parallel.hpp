// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>

namespace carom::properties {

/// Runs work(0), …, work(count − 1), each once, on so many threads, of which this is one; on fewer where no more can be
/// started. Where one throws, no more is begun, and the first exception is thrown here.
void in_parallel(unsigned jobs, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace carom::properties
