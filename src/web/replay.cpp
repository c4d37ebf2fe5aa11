// SPDX-License-Identifier: BSL-1.0
#include <optional>
#include <sstream>
#include <string>

#include <pugixml.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/report/pages/case_drawing.hpp>
#include <carom/report/pages/shown_case.hpp>
#include <carom/report/results/answer_json.hpp>
#include <carom/web/replay.hpp>
#include <carom/web/request.hpp>

namespace carom::web {
namespace {

using nlohmann::json;

/// The collision of a witness, or a record that is itself a collision.
properties::Case case_from(const json& record, bool as_drawn) {
  properties::Case one;
  const bool is_witness = record.is_object() && record.contains("collision");
  const std::string field = as_drawn ? "drawn" : "collision";
  if (is_witness && !record.contains(field)) {
    throw FormatError("/" + field, "is missing");
  }
  one.collision = is_witness ? collision_from_json(record.at(field), "/" + field) : collision_from_json(record);
  one.convex_uniform = is_witness && record.value("convex_uniform", false);
  return one;
}

/// The case of a request, in its field `text` or `collision`.
properties::Case case_of(const json& request) {
  const bool as_drawn = request.value("drawn", false);
  return request.contains("text") ? case_from(parse_json(request.at("text").get<std::string>()), as_drawn)
                                  : case_from(request.at("collision"), as_drawn);
}

std::string markup_of(const pugi::xml_node& parent) {
  std::ostringstream text;
  for (const pugi::xml_node& child : parent.children()) {
    child.print(text, "", pugi::format_raw);
  }
  return text.str();
}

Law shown_law(const json& request, const std::optional<Request>& judged) {
  if (request.value("all_laws", false)) {
    return Law::any;
  }
  if (judged) {
    return judged->subject.law;
  }
  return law_named(request.value("law", "any")).value_or(Law::any);
}

/// A collision that makes the solver fail is judged, too.
properties::AnswerAndJudgement judged_answer(const Subject& subject, const properties::Claim& claim,
                                             const properties::Case& one) {
  constexpr unsigned most_failures = 10;
  properties::Restarts restarts(most_failures);
  Session session = open_restarting(subject, restarts);
  properties::AnswerAndJudgement answered = judge_in_session(claim, session, one);
  session.close();
  return answered;
}

}  // namespace

json replay(const json& request) {
  const properties::Case one = case_of(request);
  std::optional<Request> judged;
  if (request.contains("subject")) {
    judged = request_from(request);
  }
  const Law law = shown_law(request, judged);
  report::CaseToShow to_show{request.value("place", "collision"), one, law};
  std::optional<properties::Claim> claim;
  std::optional<report::ReplayedCase> replayed;
  if (judged) {
    claim = properties::claim_of(judged->subject, judged->options.limits);
    claim->within = judged->options.within;
    properties::AnswerAndJudgement answered = judged_answer(judged->subject, *claim, one);
    replayed = report::ReplayedCase{std::move(answered.answer), std::move(answered.judgement)};
    to_show.is_filtered = claim->yardstick.filtered();
    to_show.judged = {&judged->subject, &claim->yardstick, &*replayed};
  }
  const report::ShownCase shown = report::shown_case(to_show);
  pugi::xml_document figure;
  const properties::JudgedCase judged_case(one, true, judged ? judged->subject.effects : DeclaredEffects{});
  const Answer none = Skipped{};
  report::add_case_drawing(figure, judged_case, replayed ? replayed->answer : none, law, "replayed-case",
                           "The contact");
  return {{"text", printable(shown.text, shown.text.size())},
          {"record_text", shown.record.dump(-1, ' ', false, json::error_handler_t::replace)},
          {"violated", replayed && report::is_violated(replayed->judgement)},
          {"drawing", markup_of(figure)}};
}

json judge(const json& request) {
  const Request judged = request_from(request);
  properties::Claim claim = properties::claim_of(judged.subject, judged.options.limits);
  claim.within = judged.options.within;
  const properties::AnswerAndJudgement answered = judged_answer(judged.subject, claim, case_of(request));
  json verdicts = json::object();
  for (const properties::NamedVerdict& named : answered.judgement.verdicts) {
    verdicts[std::string(named.invariant->name)] = report::Json<properties::Verdict>::write(named.verdict);
  }
  return {{"violated", report::is_violated(answered.judgement)},
          {"verdicts", verdicts},
          {"answer", report::Json<Answer>::write(answered.answer)}};
}

}  // namespace carom::web
