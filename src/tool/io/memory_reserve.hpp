// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stop_token>

namespace carom::tool {

/// From now on, where memory cannot be had, a stop is requested and what was kept back is given free, so that what was
/// found until then can be reported. Where that does not suffice either, `new` throws std::bad_alloc, and GMP, which
/// cannot, ends the program with a message. Of memory that the kernel takes back by killing nothing is known.
/// To be called once, before any other thread is started.
void keep_memory_for_the_report(const std::stop_source& stop);

/// What to say then, without asking for memory.
inline constexpr const char* out_of_memory = "carom: there is not enough memory\n";

/// Whether memory could not be had, so that a stop was requested.
[[nodiscard]] bool has_run_out_of_memory();

}  // namespace carom::tool
