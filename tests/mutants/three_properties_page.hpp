// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/properties/three_properties.hpp>

/// The generated parts of docs/reference/three-properties.md, between `<!-- begin NAME -->` and `<!-- end NAME -->`.
namespace carom::mutants {

struct PlantedRun {
  std::uint64_t seed = 1;
  std::uint64_t cases = 40;  // for each family, times its weight
  unsigned jobs = 1;
};

/// The statement of the property, its theorems, its random test, and its invariants in the gate.
[[nodiscard]] std::string facts_section(const properties::Property& property);

/// The defects that break only this property, each with the number of cases that show it.
[[nodiscard]] std::string planted_section(const properties::Property& property, const PlantedRun& run);

/// For each engine of a report.json, the number of judged cases that violate each invariant. Throws
/// nlohmann::json::exception if the report is malformed.
[[nodiscard]] std::string engines_section(const properties::Property& property, const nlohmann::json& report);

/// The page with this text between its markers. Throws std::invalid_argument if the markers are missing.
[[nodiscard]] std::string with_section(const std::string& page, std::string_view name, const std::string& text);

/// The text between the markers. Throws std::invalid_argument if the markers are missing.
[[nodiscard]] std::string section_of(const std::string& page, std::string_view name);

}  // namespace carom::mutants
