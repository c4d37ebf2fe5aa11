// SPDX-License-Identifier: BSL-1.0
#include "io/shard_argument.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

namespace carom::tool {

std::optional<std::uint64_t> number_from(std::string_view digits) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_number = error == std::errc() && end == digits.data() + digits.size();
  return is_number ? std::optional(number) : std::nullopt;
}

std::optional<properties::Shard> shard_from(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::optional<std::uint64_t> number = number_from(text.substr(0, slash));
  const std::optional<std::uint64_t> of = slash < text.size() ? number_from(text.substr(slash + 1)) : std::nullopt;
  const bool is_shard = number && of && *number >= 1 && *number <= *of && *of <= most_shards;
  return is_shard ? std::optional(properties::Shard{*number, *of}) : std::nullopt;
}

std::string is_shard(const std::string& text) {
  const bool is_one = text == automatic_shard || shard_from(text).has_value();
  return is_one ? "" : fmt::format("expected I/N with I from 1 to N and N at most {}, or auto", most_shards);
}

std::string folder_of(const properties::Shard& shard) { return fmt::format("shard-{}-of-{}", shard.number, shard.of); }

}  // namespace carom::tool
