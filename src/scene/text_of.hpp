// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <sstream>
#include <string>

namespace carom::scene {

/// The parts in one text. Numbers have six digits.
template <class... Parts>
[[nodiscard]] std::string text_of(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

}  // namespace carom::scene
