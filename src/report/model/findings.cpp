// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/report/model/answer_json.hpp>
#include <carom/report/model/findings.hpp>

namespace carom::report {
namespace {

using nlohmann::json;
using properties::FamilyResult;
using properties::ViolatedCase;

json first_record(const std::vector<ViolatedCase>& first) {
  json record = json::array();
  for (const ViolatedCase& one : first) {
    record.push_back({{"case", one.index}, {"outcome", Json<Answer>::write(one.answer)}});
  }
  return record;
}

std::uint64_t case_number(const Field& field, std::uint64_t cases) {
  const std::uint64_t number = field.count();
  if (number >= cases) {
    field.fail(fmt::format("the number of a case, less than {}", cases));
  }
  return number;
}

const std::string& invariant_of(const std::string& name, const Field& place) {
  if (properties::invariant_named(name) == nullptr) {
    place.fail("the name of an invariant");
  }
  return name;
}

}  // namespace

json findings_record(const FamilyResult& result) {
  json worst = json::object();
  for (const auto& [invariant, violation] : result.worst) {
    worst[invariant] = {{"case", violation.index},
                        {"outcome", Json<Answer>::write(violation.answer)},
                        {"verdict", Json<properties::Verdict>::write(violation.verdict)}};
  }
  return {{"violated_cases", result.violated_cases},
          {"first", first_record(result.first_violated)},
          {"first_by_relations", first_record(result.first_violated_by_relations)},
          {"worst", std::move(worst)}};
}

void read_findings(const Field& record, std::uint64_t cases,
                   const std::function<properties::Case(std::uint64_t)>& case_at, FamilyResult& into) {
  for (const auto& [name, numbers] : record.at("violated_cases").members()) {
    std::vector<std::uint64_t>& violated = into.violated_cases[invariant_of(name, numbers)];
    for (const Field& number : numbers.elements()) {
      violated.push_back(case_number(number, std::min(cases, into.sampled)));
    }
  }
  into.order_violated_cases();
  const auto read_first = [&](const char* name, std::vector<ViolatedCase>& first) {
    for (const Field& one : record.at(name).elements()) {
      const std::uint64_t number = case_number(one.at("case"), cases);
      keep_if_first(first, {number, case_at(number), Json<Answer>::read(one.at("outcome"), Reading::whole)});
    }
  };
  read_first("first", into.first_violated);
  read_first("first_by_relations", into.first_violated_by_relations);
  for (const auto& [name, one] : record.at("worst").members()) {
    const std::uint64_t number = case_number(one.at("case"), cases);
    into.keep_if_worst(invariant_of(name, one),
                       {number, case_at(number), Json<properties::Verdict>::read(one.at("verdict"), Reading::whole),
                        Json<Answer>::read(one.at("outcome"), Reading::whole)});
  }
  for (const auto& [name, count] : into.counts) {
    if (count.violated > 0) {
      (void)record.at("worst").at(name);
    }
  }
}

}  // namespace carom::report
