// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>

namespace carom {

/// The output of a foreign program, safe to print: valid UTF-8. It has no control characters except line ends and tabs,
/// and none that change the direction of writing. Longer text is cut to `longest` bytes and ends with an ellipsis. A
/// replacement character, which has three bytes, replaces each byte that is not UTF-8.
[[nodiscard]] std::string printable(std::string text, std::size_t longest);

/// The text of `printable`, with spaces in place of line ends and tabs.
[[nodiscard]] std::string printable_line(std::string text, std::size_t longest);

/// The word quoted for a POSIX shell. split_words gives the word back.
[[nodiscard]] std::string quoted(const std::string& word);

}  // namespace carom
