// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/properties/three_properties.hpp>

/// What docs/findings/three-properties.md has of the program: the text between `<!-- begin NAME -->` and
/// `<!-- end NAME -->`.
namespace carom::mutants {

struct PlantedRun {
  std::uint64_t seed = 1;
  std::uint64_t cases = 40;  // of each family, times its weight
  unsigned jobs = 1;
};

/// Its statement, its theorems, its random test, and its invariants in the gate.
[[nodiscard]] std::string facts_section(const properties::Property& property);

/// The defects that break it and nothing else, and in how many cases.
[[nodiscard]] std::string planted_section(const properties::Property& property, const PlantedRun& run);

/// What each engine of a report.json does: in how many of the judged cases each invariant is violated.
/// Throws nlohmann::json::exception where it is no report.
[[nodiscard]] std::string engines_section(const properties::Property& property, const nlohmann::json& report);

/// The page with this text between its markers. Throws std::invalid_argument where these are missing.
[[nodiscard]] std::string with_section(const std::string& page, std::string_view name, const std::string& text);

/// The text between the markers. Throws the same.
[[nodiscard]] std::string section_of(const std::string& page, std::string_view name);

}  // namespace carom::mutants
