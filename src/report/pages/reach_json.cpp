// SPDX-License-Identifier: BSL-1.0
#include <carom/collision/json/json.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/reach_pages.hpp>
#include <carom/report/results/answer_json.hpp>
#include <carom/report/results/domain_json.hpp>
#include <carom/report/results/version.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using nlohmann::json;

json domain_record(const properties::Domain& domain) { return Json<properties::Domain>::write(domain); }

json witness_record(const properties::Witness& witness) {
  return {{"invariant", witness.invariant->name},
          {"family", witness.family->name},
          {"collision", collision_to_json(witness.shrunk.collision)},
          {"violation", shown(properties::in_words(witness.verdict))}};
}

json ends_record(const properties::Ends& ends, const oracles::Limits& limits) {
  json record{
      {"yardstick", Json<oracles::Limits>::write(limits)}, {"error", shown(ends.error)}, {"faces", json::array()}};
  if (ends.in_core) {
    record["in_core"] = witness_record(*ends.in_core);
  }
  for (const properties::Face& face : ends.faces) {
    record["faces"].push_back({{"quantity", name_of(face.quantity)},
                               {"end", face.is_upper ? "most" : "least"},
                               {"value", face.end},
                               {"beyond", face.beyond ? witness_record(*face.beyond) : json()},
                               {"error", shown(face.error)}});
  }
  return record;
}

}  // namespace

json reach_record(const MeasuredDomain& measured) {
  const auto& [subject, deviates, options, reach, effects] = measured;
  json record = ends_record(reach.ends, options.limits);
  record.update({{"carom", version},
                 {"subject", subject},
                 {"seed", options.seed},
                 {"core", domain_record(options.core)},
                 {"domain", domain_record(reach.domain)},
                 {"share", reach.share},
                 {"cases", reach.cases},
                 {"not_judged", Json<properties::UnjudgedCounts>::write(reach.unjudged)}});
  if (!deviates.empty()) {
    record["deviates"] = deviates;
  }
  if (reach.stricter) {
    record["stricter"] = ends_record(*reach.stricter, *options.stricter);
  }
  return record;
}

}  // namespace carom::report
