// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <pugixml.hpp>

#include "report/records.hpp"

/// The tables of report.html. Each is appended to a section.
namespace carom::tool {

/// A table that scrolls by itself where it is wider than the page.
[[nodiscard]] pugi::xml_node add_table(pugi::xml_node section, const std::string& caption, const char* look);

/// A row of column headers.
void add_column_headers(pugi::xml_node table, const std::vector<std::string>& names);

/// Where on the page a witness stands.
[[nodiscard]] std::string witness_anchor(std::size_t subject, const std::string& invariant);

/// "sound", "3 violated", … with a sign before it.
[[nodiscard]] std::string verdict_in_words(const properties::SubjectResult& result);

/// A line a subject; what a subject that could not be judged said stands below.
void add_subjects(pugi::xml_node section, const GateRun& run);

/// Subject × invariant.
void add_invariants(pugi::xml_node section, const GateRun& run);

/// Subject × family, the worst backward error in each.
void add_families(pugi::xml_node section, const GateRun& run);

/// What features the cases had, and which pairs of features none had.
void add_features(pugi::xml_node section, const GateRun& run);

/// What was generated.
void add_coverage(pugi::xml_node section, const GateRun& run);

}  // namespace carom::tool
