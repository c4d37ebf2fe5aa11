// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stop_token>

namespace carom::tool {

/// Reserves memory for the report. If an allocation fails, the reserve is released and a stop is requested, so that the
/// results so far can be reported. If the reserve is not enough, `new` throws std::bad_alloc, and an allocation of GMP
/// ends the program with a message, because GMP cannot handle exceptions. Call this function once, before any other
/// thread is started.
void keep_memory_for_the_report(const std::stop_source& stop);

/// Throws UsageError if the limit on the stack is too low for this program and its threads.
void require_stack();

/// Prints on standard error that memory is exhausted, and its limit. This allocates no memory.
void print_out_of_memory();

/// Whether an allocation failed, so that a stop was requested.
[[nodiscard]] bool has_run_out_of_memory();

}  // namespace carom::tool
