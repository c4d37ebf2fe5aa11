// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>

namespace carom::report {

/// The text for a missing number.
inline constexpr const char* no_number = "–";

/// The numbers of correct digits that 50 %, 99 % and 100 % of the cases reach. None if no digits were measured.
struct Digits {
  std::optional<double> p50;
  std::optional<double> p99;
  std::optional<double> worst;
};

/// "15.2", or no_number.
[[nodiscard]] std::string in_tenths(const std::optional<double>& number);

/// "15.2 / 14.0 / 12.9", or no_number.
[[nodiscard]] std::string in_words(const Digits& digits);

}  // namespace carom::report
