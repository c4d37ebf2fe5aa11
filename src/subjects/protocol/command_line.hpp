// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom::subjects::protocol {

/// Splits and unquotes text as a POSIX shell does (Shell Command Language §2.2): blanks, '…', "…" and \. No other shell
/// syntax applies: $, *, ; and the like are ordinary characters. Throws std::invalid_argument if a quotation is not
/// closed, or if the text ends in \.
[[nodiscard]] std::vector<std::string> split_words(std::string_view text);

}  // namespace carom::subjects::protocol
