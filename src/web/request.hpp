// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/properties/gate/gate_report.hpp>
#include <carom/report/results/run.hpp>

namespace carom::web {

/// The solver and the run of a request.
struct Request {
  Subject subject;
  properties::GateOptions options;
  std::vector<std::string> families;                    // names; empty for all
  std::vector<const properties::Family*> without_case;  // families that have no case within the domain
  std::vector<std::string> deviates;                    // of the run
  report::Environment environment;
  std::string out;  // the directory of the witnesses, as the report shows it
};

/// Reads the fields `subject` and `options` of a request about one collision. src/web/README.md describes them. Throws
/// FormatError or std::invalid_argument that names the field or the option.
[[nodiscard]] Request request_from(const nlohmann::json& record);

/// `request_from` for a run, with its families. Throws also if a family has no case within the domain.
[[nodiscard]] Request run_request_from(const nlohmann::json& record);

/// The domain of the field `within` of a request; everything if there is none. Throws std::invalid_argument.
[[nodiscard]] properties::Domain domain_of(const nlohmann::json& request);

/// A whole number, also as text, because JavaScript's numbers end at 2^53. Throws FormatError.
[[nodiscard]] std::uint64_t count_from(const nlohmann::json& value, const std::string& place);

}  // namespace carom::web
