// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <carom/properties/records/tally.hpp>

/// The judgement of recorded collisions (`carom check`), in every form.
namespace carom::report {

/// 1 if a record is violated. Otherwise 2 if more than a tenth was not judged, or 0. 2 in any case if the file was not
/// read to its end.
[[nodiscard]] int exit_status_of(const properties::records::RecordsReport& report);

/// For a terminal. The verdict comes first.
[[nodiscard]] std::string records_text(const properties::records::RecordsReport& report);

/// report.html: one page that needs no script, network or other file.
[[nodiscard]] std::string records_html(const properties::records::RecordsReport& report);

/// report.json (docs/reference/schemas/records.schema.json).
[[nodiscard]] nlohmann::json records_record(const properties::records::RecordsReport& report);

/// JUnit's XML: a suite for the file, with a test for each invariant that the law claims.
[[nodiscard]] std::string records_junit(const properties::records::RecordsReport& report);

}  // namespace carom::report
