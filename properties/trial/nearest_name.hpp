// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom::properties {

/// The name that was meant by a misspelt word: the one that fewest letters added, left out, changed, or swapped with
/// their neighbour make of it, the first of several; none where that takes more than two, or a third of the word.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view word, const std::vector<std::string>& names);

/// "; did you mean 'NAME'?", to end a complaint about the word with; empty where no name is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace carom::properties
