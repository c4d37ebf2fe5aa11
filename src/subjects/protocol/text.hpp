// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>

namespace carom::subjects::protocol {

/// What a foreign program wrote, safe to print: valid UTF-8 with no control characters but line ends and tabs, none
/// that change the direction of writing, and at most so many bytes, an ellipsis aside.
[[nodiscard]] std::string printable(std::string text, std::size_t longest);

/// The same with blanks for line ends and tabs.
[[nodiscard]] std::string printable_line(std::string text, std::size_t longest);

}  // namespace carom::subjects::protocol
