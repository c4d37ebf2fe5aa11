// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom::properties {

/// The name that the fewest letters added, left out or replaced make of the word; of equals the first. Empty where
/// there are no names.
[[nodiscard]] std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

}  // namespace carom::properties
