// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom::properties {

/// The name that a misspelt word probably means: the first name with the fewest edits. An edit adds, removes or changes
/// a letter, or swaps two neighbours. No value if more than two edits are needed, or more than a third of the word's
/// length.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view word, const std::vector<std::string>& names);

/// "; did you mean 'NAME'?", to end an error message. Empty if no name is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace carom::properties
