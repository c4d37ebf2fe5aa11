// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom::subjects::protocol {

/// Splits and unquotes as a POSIX shell would (Shell Command Language §2.2): blanks separate words, '…' keeps
/// everything, "…" and \ what a shell lets them. Nothing else that a shell does is done: $, *, ; and their like are
/// letters. Throws std::invalid_argument where a quotation is not closed.
[[nodiscard]] std::vector<std::string> split_words(std::string_view text);

}  // namespace carom::subjects::protocol
