// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>

namespace carom {

/// Makes the text of a foreign program safe to print: valid UTF-8 without control characters (except line ends and
/// tabs) and without marks that change the direction of writing. Text of more than `longest` bytes is cut, and ends
/// with an ellipsis. Each byte that is not UTF-8 becomes a replacement character (three bytes).
[[nodiscard]] std::string printable(std::string text, std::size_t longest);

/// The text of `printable`, with spaces in place of line ends and tabs.
[[nodiscard]] std::string printable_line(std::string text, std::size_t longest);

/// The word quoted for a POSIX shell. `split_words` reads it back.
[[nodiscard]] std::string quoted(const std::string& word);

}  // namespace carom
