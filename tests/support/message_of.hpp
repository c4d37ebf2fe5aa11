// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

namespace carom::unit {

/// The message of the `Error` that `call` throws. Empty if `call` throws nothing.
template <class Error, class Call>
[[nodiscard]] std::string message_of(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace carom::unit
