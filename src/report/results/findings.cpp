// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/report/results/findings.hpp>
#include <carom/report/results/values_json.hpp>

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

constexpr std::array<const char*, properties::all_answer_kinds.size()> names_of_kinds{"outcome", "not_finite",
                                                                                      "refused", "failed", "skipped"};

/// The twelve numbers of an outcome, or the kind of another answer.
json answer_record(const properties::SampledAnswer& answer) {
  if (answer.kind != properties::AnswerKind::outcome) {
    return names_of_kinds[static_cast<std::size_t>(answer.kind)];
  }
  json numbers = json::array();
  const auto from = vectors(answer.outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      numbers.push_back(number_to_json((*from[k])[i]));
    }
  }
  return numbers;
}

properties::SampledAnswer answer_from(std::uint64_t index, const Field& field) {
  properties::SampledAnswer answer{index, properties::AnswerKind::outcome, {}};
  if (field.value().is_string()) {
    const auto found = std::ranges::find(names_of_kinds, field.text());
    if (found == names_of_kinds.end() || found == names_of_kinds.begin()) {
      field.fail("the kind of an answer: not_finite, refused, failed or skipped");
    }
    answer.kind = static_cast<properties::AnswerKind>(found - names_of_kinds.begin());
    return answer;
  }
  const std::vector<Field> numbers = field.elements();
  if (numbers.size() != 3 * all_outcome_vectors.size()) {
    field.fail("twelve numbers");
  }
  const auto into = vectors(answer.outcome);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    (*into[all_outcome_vectors[i / 3]])[static_cast<int>(i % 3)] = numbers[i].number();
  }
  return answer;
}

json answer_records(const std::vector<properties::SampledAnswer>& answers) {
  json record = json::array();
  for (const properties::SampledAnswer& one : answers) {
    record.push_back({{"case", one.index}, {"answer", answer_record(one)}});
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

}  // namespace

json findings_record(const FamilyResult& result) {
  json worst = json::object();
  for (const auto& [invariant, violation] : result.worst) {
    worst[std::string(invariant->name)] = {{"case", violation.index},
                                           {"outcome", Json<Answer>::write(violation.answer)},
                                           {"verdict", Json<properties::Verdict>::write(violation.verdict)}};
  }
  return {{"skipped_cases", result.skipped_cases},
          {"violated_cases", Json<properties::PerInvariant<std::vector<std::uint64_t>>>::write(result.violated_cases)},
          {"answers", answer_records(result.sampled_answers)},
          {"first", first_record(result.first_violated)},
          {"first_by_relations", first_record(result.first_violated_by_relations)},
          {"worst", std::move(worst)}};
}

void read_findings(const Field& record, std::uint64_t cases,
                   const std::function<properties::Case(std::uint64_t)>& case_at, FamilyResult& into) {
  for (const Field& number : record.at("skipped_cases").elements()) {
    into.skipped_cases.push_back(case_number(number, std::min(cases, into.sampled)));
  }
  for (const auto& [name, numbers] : record.at("violated_cases").members()) {
    std::vector<std::uint64_t>& violated = into.violated_cases[&invariant_at(name, numbers)];
    for (const Field& number : numbers.elements()) {
      violated.push_back(case_number(number, std::min(cases, into.sampled)));
    }
  }
  for (const Field& one : record.at("answers").elements()) {
    into.sampled_answers.push_back(
        answer_from(case_number(one.at("case"), std::min(cases, into.sampled)), one.at("answer")));
  }
  into.order_cases();
  const auto read_first = [&](const char* name, std::vector<ViolatedCase>& first) {
    for (const Field& one : record.at(name).elements()) {
      const std::uint64_t number = case_number(one.at("case"), cases);
      keep_if_first(first, {number, case_at(number), Json<Answer>::read(one.at("outcome"))});
    }
  };
  read_first("first", into.first_violated);
  read_first("first_by_relations", into.first_violated_by_relations);
  for (const auto& [name, one] : record.at("worst").members()) {
    const std::uint64_t number = case_number(one.at("case"), cases);
    into.keep_if_worst(invariant_at(name, one),
                       {number, case_at(number), Json<properties::Verdict>::read(one.at("verdict")),
                        Json<Answer>::read(one.at("outcome"))});
  }
  for (const auto& [invariant, count] : into.counts) {
    if (count.violated > 0) {
      (void)record.at("worst").at(std::string(invariant->name));
    }
  }
}

}  // namespace carom::report
