// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/exact_steps.hpp>
#include <carom/report/pages/shown_case.hpp>
#include <carom/report/results/answer_json.hpp>

namespace carom::report {
namespace {

using nlohmann::json;
using properties::in_words;

std::string joined(const std::vector<const properties::Feature*>& features) {
  std::string text;
  for (const properties::Feature* feature : features) {
    text += (text.empty() ? "" : ", ") + feature->name;
  }
  return text;
}

std::string digits_in_words(double digits) {
  return std::isfinite(digits) ? fmt::format("{:.1f} digits", digits)
                               : "no digits known: the exact change is zero or out of range";
}

/// The number of correct digits of an outcome, compared with the nearest answer of the law `coulomb`.
std::string nearest_answer_text(const oracles::ExactCase& exact_case, const Answer& answer,
                                const std::vector<oracles::CoulombAnswer>& answers) {
  const auto* outcome = std::get_if<ReportedOutcome>(&answer);
  if (outcome == nullptr || !oracles::is_finite(*outcome)) {
    return {};
  }
  const oracles::NearestAnswer nearest = oracles::nearest_answer(exact_case, answers, *outcome);
  return fmt::format("  answer {} of {}: {}\n", nearest.number + 1, answers.size(), digits_in_words(nearest.digits));
}

std::string judgement_text(const properties::Judgement& judgement, const Answer& answer, double unit_roundoff) {
  std::string text;
  if (const auto* outcome = std::get_if<ReportedOutcome>(&answer)) {
    text += in_words(*outcome, "  ");
  } else if (const auto* refused = std::get_if<Refused>(&answer)) {
    text += "  refused: " + refused->why + '\n';
  } else if (const auto* failed = std::get_if<Failed>(&answer)) {
    text += "  " + failed->why + "\n    " + properties::indented(failed->said, "    ") + '\n';
  } else {
    text += "  skipped: " + std::get<Skipped>(answer).why + '\n';
  }
  if (judgement.accuracy) {
    text += judgement.accuracy->is_decided
                ? fmt::format("  backward error {:.3g} ulps, {}\n", judgement.accuracy->backward_error(unit_roundoff),
                              digits_in_words(judgement.accuracy->digits()))
                : "  backward error not decided: the scale overflows or underflows\n";
  }
  for (const properties::NamedVerdict& named : judgement.verdicts) {
    const properties::Verdict& verdict = named.verdict;
    switch (verdict.status) {
      case properties::Status::holds:
        text += fmt::format("  {:22} holds\n", named.invariant->name);
        break;
      case properties::Status::skipped:
        text += fmt::format("  {:22} –  {}\n", named.invariant->name, verdict.detail);
        break;
      case properties::Status::violated:
        text += fmt::format("  {:22} VIOLATED  {}\n", named.invariant->name, in_words(verdict));
    }
  }
  return text;
}

/// Adds the exact outcome under the law, or under each law for `any`. Returns the answers of `coulomb` if it is shown.
/// Precondition: the case is valid.
std::vector<oracles::CoulombAnswer> show_truth(const Collision& collision, const properties::JudgedCase& judged_case,
                                               Law shown_law, ShownCase& shown) {
  const oracles::ExactCase& exact_case = judged_case.exact();
  const std::vector<const properties::Feature*> features = properties::features_of(collision);
  shown.record["approach"] = in_words_of(exact_case.approach());
  shown.record["features"] = json::array();
  for (const properties::Feature* feature : features) {
    shown.record["features"].push_back(feature->name);
  }
  shown.text += "  features: " + joined(features) + '\n' + contact_steps(exact_case);
  const auto is_shown = [&](Law law) { return shown_law == law || shown_law == Law::any; };
  for (const Law law : laws_with_truth) {
    if (!is_shown(law)) {
      continue;
    }
    shown.record["truth"][std::string(carom::name_of(law))] = truth_record(exact_case, law);
    shown.text += truth_steps(exact_case, law);
  }
  if (!is_shown(Law::coulomb)) {
    return {};
  }
  std::vector<oracles::CoulombAnswer> answers = oracles::coulomb_answers(exact_case);
  shown.record["answers"]["coulomb"] = answers_record(answers);
  shown.text += answers_steps(exact_case, answers);
  return answers;
}

void show_judgement(const CaseToShow::Judged& judged, ShownCase& shown) {
  const auto& [subject, yardstick, replayed] = judged;
  const properties::Judgement& judgement = replayed->judgement;
  json& record = shown.record;
  record["subject"] = subject->name;
  record["yardstick"] = Json<oracles::Limits>::write(yardstick->limits());
  record["outcome"] = Json<Answer>::write(replayed->answer);
  if (judgement.accuracy) {
    record["backward_error_ulps"] = judgement.accuracy->is_decided
                                        ? number_to_json(judgement.accuracy->backward_error(yardstick->unit_roundoff()))
                                        : json();
  }
  for (const properties::NamedVerdict& named : judgement.verdicts) {
    record["verdicts"][std::string(named.invariant->name)] = Json<properties::Verdict>::write(named.verdict);
  }
  if (replayed->spellings > 0) {
    record["spellings"] = replayed->spellings;
    record["violated_spellings"] = replayed->violated_spellings;
    record["spelt"] = replayed->spelt;
  }
  if (replayed->violated_spellings > 0 && replayed->violated_spellings < replayed->spellings) {
    shown.text += fmt::format("  violated in {} of {} spellings of the request, first in {}\n",
                              replayed->violated_spellings, replayed->spellings, replayed->spelt);
  }
  shown.text += fmt::format("{}, judged{}\n{}", subject->name, yardstick->filtered() ? "" : " only in exact arithmetic",
                            judgement_text(judgement, replayed->answer, yardstick->unit_roundoff()));
}

}  // namespace

bool is_violated(const properties::Judgement& judgement) {
  return std::any_of(judgement.verdicts.begin(), judgement.verdicts.end(), [](const properties::NamedVerdict& named) {
    return named.verdict.status == properties::Status::violated;
  });
}

ShownCase shown_case(const CaseToShow& to_show) {
  const auto& [place, one, law, is_filtered, why_not_judged, judged] = to_show;
  ShownCase shown{{{"place", place}, {"collision", collision_to_json(one.collision)}},
                  fmt::format("{}\n{}", place, in_words(one.collision, "  "))};
  const DeclaredEffects effects = judged.subject != nullptr ? judged.subject->effects : DeclaredEffects{};
  const properties::JudgedCase judged_case(one, is_filtered, effects);
  std::vector<oracles::CoulombAnswer> answers;
  if (const std::string declared = properties::to_text(effects); !declared.empty()) {
    shown.text += fmt::format("  {} declares {}; the exact outcome is the law's, before damping and limits of speeds\n",
                              judged.subject->name, declared);
  }
  if (judged_case.is_valid()) {
    answers = show_truth(one.collision, judged_case, law, shown);
  } else {
    shown.text += "  an invalid collision: it has no exact outcome, and a subject must refuse it\n";
  }
  if (judged.replayed != nullptr) {
    show_judgement(judged, shown);
    if (judged.subject->law == Law::coulomb && judged_case.is_valid()) {
      shown.text += nearest_answer_text(judged_case.exact(), judged.replayed->answer, answers);
    }
  }
  if (!why_not_judged.empty()) {
    shown.record["not_judged"] = why_not_judged;
    shown.text += "  " + why_not_judged + '\n';
  }
  return shown;
}

}  // namespace carom::report
