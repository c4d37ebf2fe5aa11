// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/gate/gate.hpp>

namespace carom::web_tests {

inline nlohmann::json family_record(const properties::FamilyResult& result) {
  nlohmann::json record = {{"cases", result.cases}, {"worst", fmt::format("{:.3g}", result.worst_backward_error)}};
  for (const auto& [invariant, count] : result.counts) {
    record["counts"][std::string(invariant->name)] = {count.holds, count.violated, count.skipped};
  }
  return record;
}

/// The verdicts on the first cases of every family: the status, the counts of each family, the witnesses, and figures
/// of three digits.
inline nlohmann::json verdicts_on(const Subject& subject, std::uint64_t cases) {
  properties::GateOptions options;
  options.cases = cases;
  options.relations_every = 1;
  for (const properties::Family& family : properties::all_families()) {
    options.families.push_back(&family);
  }
  const properties::SubjectResult result = properties::run_gate({subject}, options).results[0];
  nlohmann::json record = {{"subject", subject.name},
                           {"error", result.error},
                           {"not_judged", result.not_judged},
                           {"sound", result.is_sound()},
                           {"witnesses", nlohmann::json::object()}};
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    record["families"][std::string(options.families[f]->name)] = family_record(result.families[f]);
  }
  for (const properties::Witness& witness : result.witnesses) {
    record["witnesses"][std::string(witness.invariant->name)] = {
        {"family", witness.family->name},
        {"case", witness.index},
        {"collision", collision_to_json(witness.shrunk.collision)},
        {"residual", fmt::format("{:.3g}", witness.verdict.residual)},
        {"allowed", fmt::format("{:.3g}", witness.verdict.allowed)}};
  }
  if (const auto digits = result.digits_at_least(0.5)) {
    record["digits"] = fmt::format("{:.3g}", *digits);
  }
  return record;
}

}  // namespace carom::web_tests
