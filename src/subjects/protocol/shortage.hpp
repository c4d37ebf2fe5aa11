// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <system_error>

namespace carom::subjects::protocol {

/// Which resource is short, and the limit on it: "at most 5 files may be open (ulimit -n)". The resources are processes
/// and threads, memory, and open files. Empty if the error tells of no shortage. If the system starts no thread, it
/// does not say whether threads or memory are short. The function finds out.
[[nodiscard]] std::string shortage(const std::error_code& error);

/// The message of an error, with the shortage in parentheses if there is one.
[[nodiscard]] std::string message_of(const std::error_code& error);

}  // namespace carom::subjects::protocol
