// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include <carom/report/results/duration.hpp>

namespace carom::report {
namespace {

struct Unit {
  std::string_view name;
  std::chrono::milliseconds length;
};

constexpr std::array units{Unit{"h", std::chrono::hours(1)}, Unit{"m", std::chrono::minutes(1)},
                           Unit{"s", std::chrono::seconds(1)}, Unit{"ms", std::chrono::milliseconds(1)}};

}  // namespace

std::optional<std::chrono::nanoseconds> duration_from(std::string_view text) {
  constexpr double shortest = 1e-3;        // [s]
  constexpr double longest = 1000 * 3600;  // [s]
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  if (error != std::errc()) {
    return std::nullopt;
  }
  const std::string_view name(end, static_cast<std::size_t>(text.data() + text.size() - end));
  for (const Unit& unit : units) {
    const double seconds = number * std::chrono::duration<double>(unit.length).count();
    if (name == unit.name && seconds >= shortest && seconds <= longest) {
      return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
    }
  }
  return std::nullopt;
}

std::string in_words(std::chrono::nanoseconds duration) {
  const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(duration);
  for (const Unit& unit : units) {
    if (milliseconds >= unit.length && milliseconds % unit.length == std::chrono::milliseconds::zero()) {
      return fmt::format("{} {}", milliseconds / unit.length, unit.name);
    }
  }
  return "0 ms";
}

}  // namespace carom::report
