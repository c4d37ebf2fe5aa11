// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <string>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "report/records.hpp"

/// Where each subject stops beyond the claimed domain, in every form of a report. None of it is a verdict.
namespace carom::tool {

/// Of the whole run: the families, and of what each has much.
[[nodiscard]] nlohmann::json beyond_domain_families_record(const properties::GateOptions& options);

/// Of a subject: what came of it in each of them, with the least of the quantity at which something is violated.
[[nodiscard]] nlohmann::json beyond_domain_record(const properties::SubjectResult& result,
                                                  const properties::GateOptions& options);

/// A line for each subject that counts; empty if no such family was posed.
[[nodiscard]] std::string beyond_domain_text(const GateRun& run);

/// The same as a table of Markdown; `shown` makes names of subjects safe to stand in it.
[[nodiscard]] std::string beyond_domain_markdown(const GateRun& run,
                                                 const std::function<std::string(const std::string&)>& shown);

/// A table of all subjects; nothing if no such family was posed.
void add_beyond_domain(pugi::xml_node section, const GateRun& run);

/// The same as properties of a suite of JUnit's, which have to stand before its tests.
void add_beyond_domain_properties(pugi::xml_node suite, const properties::SubjectResult& result,
                                  const properties::GateOptions& options);

}  // namespace carom::tool
