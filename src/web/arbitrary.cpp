// SPDX-License-Identifier: BSL-1.0
#include "arbitrary.hpp"

#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <carom/collision/json/json.hpp>
#include <carom/properties/domains/draw_within.hpp>
#include <carom/properties/families/choices.hpp>
#include <carom/properties/gate/posed_families.hpp>
#include <carom/properties/search/simpler_cases.hpp>

#include "request.hpp"

namespace carom::web {
namespace {

using nlohmann::json;

/// Draws cases of the family, or of any family if the request names none. A case that does not fit into the domain
/// stays as it was drawn.
properties::Draw draw_of(const json& request) {
  properties::Draw draw = properties::case_of_any_family;
  std::optional<properties::LimitedQuantity> keeps;
  if (request.contains("family")) {
    const properties::Family& family = properties::require_family("family", request.at("family").get<std::string>());
    draw = family.generate;
    keeps = family.keeps;
  }
  if (!request.contains("within")) {
    return draw;
  }
  return [draw = std::move(draw), keeps,
          within = domain_given(request.at("within").get<std::string>())](properties::Stream& stream) {
    properties::Case one = draw(stream);
    properties::Case fitted = one;
    return fit_into(within, keeps, stream, fitted) ? fitted : one;
  };
}

json choices_of(const std::vector<properties::Choice>& choices) {
  json record = json::array();
  for (const properties::Choice& choice : choices) {
    const properties::StreamQuestion& question = choice.question;
    record.push_back({std::to_string(question.count), std::to_string(question.simplest), question.is_of_plainness,
                      std::to_string(choice.answer)});
  }
  return record;
}

std::vector<properties::Choice> choices_from(const json& record) {
  std::vector<properties::Choice> choices;
  for (const json& one : record) {
    choices.push_back({{count_from(one.at(0), "/choices"), count_from(one.at(1), "/choices"), one.at(2).get<bool>()},
                       count_from(one.at(3), "/choices")});
  }
  return choices;
}

json record_of(const properties::ChosenCase& chosen) {
  return {{"collision", collision_to_json(chosen.one.collision)}, {"choices", choices_of(chosen.choices)}};
}

}  // namespace

json chosen(const json& request) {
  std::mt19937_64 words(count_from(request.at("seed"), "/seed"));
  const auto size = static_cast<int>(count_from(request.at("size"), "/size"));
  return record_of(properties::chosen_case(
      draw_of(request), [&] { return words(); }, size));
}

json simpler(const json& request) {
  const properties::Draw draw = draw_of(request);
  properties::SimplerCases cases(draw, properties::replayed_case(draw, choices_from(request.at("choices"))),
                                 count_from(request.at("first"), "/first"));
  json records = json::array();
  const std::uint64_t most = count_from(request.at("most"), "/most");
  for (std::uint64_t i = 0; i < most; ++i) {
    const std::optional<properties::ChosenCase> next = cases.next();
    if (!next) {
      break;
    }
    records.push_back(record_of(*next));
    records.back()["place"] = cases.place();
  }
  return {{"cases", records}};
}

}  // namespace carom::web
