// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace carom::report {

/// The format of a duration, for error messages.
inline constexpr const char* duration_form = "a number and a unit, for example 500ms, 10s, 2m or 1h, from 1ms to 1000h";

/// Parses "500ms", "10s", "2m" or "1.5h": a decimal number followed by its unit. None if the text is anything else, or
/// if the duration is less than a millisecond or more than 1000 hours.
[[nodiscard]] std::optional<std::chrono::nanoseconds> duration_from(std::string_view text);

/// The duration in words, with the largest unit that leaves no fraction: "500 ms", "90 s" or "2 m". A fraction of a
/// millisecond is left out.
[[nodiscard]] std::string in_words(std::chrono::nanoseconds duration);

}  // namespace carom::report
