// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::tool {

/// Writes what is buffered for standard output. Throws a std::system_error with the code `broken_pipe` if the reader is
/// gone, as fmt::print does. Throws UsageError if the output cannot be written for another reason.
void flush_output();

/// Ends the process by SIGPIPE, as if the process did not ignore this signal. A shell with `pipefail` then reports an
/// error, because nobody read the verdict.
[[noreturn]] void end_by_closed_pipe();

}  // namespace carom::tool
