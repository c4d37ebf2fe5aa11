// SPDX-License-Identifier: BSL-1.0
#include "merge/shard_record.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <carom/collision/json/json.hpp>

#include "merge/findings.hpp"

namespace carom::tool::merge {
namespace {

using nlohmann::json;

json digits_record(const properties::Histogram<properties::DigitsScale>& digits) {
  json bins = json::array();
  const std::vector<std::uint64_t>& counts = digits.counts();
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    if (counts[bin] > 0) {
      bins.push_back({bin, counts[bin]});
    }
  }
  return {{"smallest", number_to_json(digits.smallest())},
          {"largest", number_to_json(digits.largest())},
          {"bins", std::move(bins)}};
}

}  // namespace

json shard_record(const properties::GateReport& report) {
  json record{{"number", report.options.shard.number},
              {"of", report.options.shard.of},
              {"digits", json::array()},
              {"findings", json::array()}};
  for (const properties::SubjectResult& result : report.results) {
    record["digits"].push_back(digits_record(result.digits));
    json findings = json::object();
    for (std::size_t f = 0; f < result.families.size(); ++f) {
      if (!result.families[f].worst.empty()) {
        findings[report.options.families[f]->name] = findings_record(result.families[f]);
      }
    }
    record["findings"].push_back(std::move(findings));
  }
  return record;
}

}  // namespace carom::tool::merge
