// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <carom/properties/records/tally.hpp>

/// The judgement of recorded collisions (`carom check`), in every form.
namespace carom::report {

/// 0 if all records hold, 1 if one is violated, 2 if the file was not read to its end or no record was judged.
[[nodiscard]] int exit_status_of(const properties::records::RecordsReport& report);

/// For a terminal. The verdict comes first.
[[nodiscard]] std::string records_text(const properties::records::RecordsReport& report);

/// report.html: one page that needs no script, network or other file.
[[nodiscard]] std::string records_html(const properties::records::RecordsReport& report);

/// report.json.
[[nodiscard]] nlohmann::json records_record(const properties::records::RecordsReport& report);

/// JUnit's XML: a suite for the file, with a test for each invariant that the law claims.
[[nodiscard]] std::string records_junit(const properties::records::RecordsReport& report);

}  // namespace carom::report
