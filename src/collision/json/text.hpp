// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>

namespace carom {

/// What a foreign program wrote, safe to print: valid UTF-8 with no control characters but line ends and tabs, none
/// that change the direction of writing. Of a text that is longer, so many bytes and an ellipsis. A byte that is no
/// UTF-8 becomes a replacement character, which has three.
[[nodiscard]] std::string printable(std::string text, std::size_t longest);

/// The same with blanks for line ends and tabs.
[[nodiscard]] std::string printable_line(std::string text, std::size_t longest);

/// The word as a POSIX shell reads it: split_words gives it back.
[[nodiscard]] std::string quoted(const std::string& word);

}  // namespace carom
