// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::tool {

/// The argument of --shard that takes the shard from the batch system.
inline constexpr std::string_view automatic_shard = "auto";

/// A run has at most this many shards.
inline constexpr std::uint64_t most_shards = 1'000'000;

/// The number that the text is, in decimal digits only; none if it is no number of 64 bits.
[[nodiscard]] std::optional<std::uint64_t> number_from(std::string_view digits);

/// Parses "2/3". None if the text is not I/N with 1 ≤ I ≤ N ≤ most_shards.
[[nodiscard]] std::optional<properties::Shard> shard_from(std::string_view text);

/// The error message if the text is neither automatic_shard nor I/N; empty if it is one of them.
[[nodiscard]] std::string is_shard(const std::string& text);

/// "shard-2-of-3", the folder of a shard's reports.
[[nodiscard]] std::string folder_of(const properties::Shard& shard);

}  // namespace carom::tool
