// SPDX-License-Identifier: BSL-1.0
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/cases/choices.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/gate/shrink.hpp>
#include <carom/web/commands.hpp>
#include <carom/web/request.hpp>

namespace carom::web {
namespace {

using nlohmann::json;

/// Draws cases of the family. A case that does not fit into the domain stays as it was drawn.
properties::Draw draw_of(const json& request) {
  const properties::Family& family = properties::require_family("family", request.at("family").get<std::string>());
  return [&family, within = domain_of(request)](properties::Stream& stream) {
    properties::Case one;
    static_cast<void>(draw_into(within, family, stream, one));
    return one;
  };
}

/// Whether the domain contains the collision, or the collision is invalid, so that it lies in every domain.
bool fits(const properties::Domain& within, const Collision& collision) {
  return within.is_everything() || !validate(collision).empty() || contains(within, collision);
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
  constexpr int most_draws = 64;
  const properties::Draw draw = draw_of(request);
  const properties::Domain within = domain_of(request);
  const auto size = static_cast<int>(count_from(request.at("size"), "/size"));
  std::mt19937_64 words(count_from(request.at("seed"), "/seed"));
  for (int i = 0; i < most_draws; ++i) {
    const properties::ChosenCase one = properties::chosen_case(
        draw, [&] { return words(); }, size);
    if (fits(within, one.one.collision)) {
      return record_of(one);
    }
  }
  throw std::invalid_argument("no case of " + request.at("family").get<std::string>() + " lies within " +
                              to_text(within));
}

json simpler(const json& request) {
  const properties::Draw draw = draw_of(request);
  const properties::Domain within = domain_of(request);
  const std::uint64_t most = count_from(request.at("most"), "/most");
  properties::SimplerCases cases(draw, properties::replayed_case(draw, choices_from(request.at("choices"))),
                                 count_from(request.at("first"), "/first"));
  json records = json::array();
  while (records.size() < most) {
    const std::optional<properties::ChosenCase> next = cases.next();
    if (!next) {
      break;
    }
    if (fits(within, next->one.collision)) {
      records.push_back(record_of(*next));
      records.back()["place"] = cases.place();
    }
  }
  return {{"cases", records}};
}

}  // namespace carom::web
