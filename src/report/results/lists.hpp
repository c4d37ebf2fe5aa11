// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>

#include <nlohmann/json.hpp>

/// Lists of names and their meanings, as JSON arrays.
namespace carom::report {

[[nodiscard]] nlohmann::json invariants_list();
[[nodiscard]] nlohmann::json features_list();
/// Each family has an example: its first case of this seed.
[[nodiscard]] nlohmann::json families_list(std::uint64_t seed);
/// The domains that ship with Carom.
[[nodiscard]] nlohmann::json domains_list();

}  // namespace carom::report
