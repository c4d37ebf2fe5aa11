// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/shown_case.hpp>
#include <carom/report/pictures/contact_drawing.hpp>
#include <carom/report/pictures/markup.hpp>
#include <carom/report/results/values_json.hpp>

namespace carom::report {
namespace {

using nlohmann::json;
using oracles::ContactState;
using oracles::Rational;
using properties::in_words;

const char* name_of(oracles::Branch branch) {
  switch (branch) {
    case oracles::Branch::inside_cone:
      return ", inside the friction cone";
    case oracles::Branch::on_cone:
      return ", on the friction cone";
    case oracles::Branch::only:
      break;
  }
  return "";
}

template <class T>
std::string truth_steps(const BasicCollision<T>& c, const oracles::Truth<T>& truth, ContactState approach) {
  const Vector3<T> after = oracles::relative_velocity<T>(c, truth.outcome);
  std::string text = fmt::format("  F = {}\n", in_words(truth.impulse));
  const auto parts = vectors(truth.outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    text += fmt::format("  {}⁺ = {}\n", carom::name_of(k), in_words(*parts[k]));
  }
  text += fmt::format("  V⁺ = {}\n  N·V⁺ = {}\n", in_words(after), in_words(T(c.normal.dot(after))));
  if (approach != ContactState::inert) {
    const auto energy = oracles::equation::Energy{}(c, truth.outcome);
    text += fmt::format("  E⁺ − E⁻ − W = {}\n", in_words(T(energy.left[0] - energy.right[0])));
  }
  return text;
}

const char* in_words_of(ContactState approach) {
  switch (approach) {
    case ContactState::colliding:
      return "colliding";
    case ContactState::resting:
      return "resting";
    case ContactState::separating:
      return "separating";
    case ContactState::inert:
      break;
  }
  return "both bodies are immovable";
}

std::string contact_steps(const oracles::ExactCase& exact_case) {
  const BasicCollision<Rational>& c = exact_case.exact();
  const Outcome<Rational> before = unchanged(c);
  const Matrix3<Rational>& k = exact_case.collision_matrix();
  std::string text =
      fmt::format("  r_A = P − X_A = {}\n  r_B = P − X_B = {}\n", in_words<Rational>(oracles::lever_arm(c.a, c.point)),
                  in_words<Rational>(oracles::lever_arm(c.b, c.point)));
  const Rational normal_velocity = oracles::normal_velocity_before(c);
  const double length = oracles::norm_of(exact_case.collision().normal);
  text += fmt::format(
      "  V⁻ = {}\n  N·V⁻ = {}: {}{}\n", in_words<Rational>(oracles::relative_velocity<Rational>(c, before)),
      in_words(normal_velocity), in_words_of(exact_case.state()),
      length == 1 || normal_velocity == 0 ? ""
                                          : fmt::format(", at {:.3g} m/s along the normal",
                                                        std::abs(oracles::nearest_double(normal_velocity)) / length));
  if (exact_case.state() != ContactState::inert) {
    text += fmt::format("  λ = {}\n", in_words(oracles::inverse_mass(c)));
    for (int row = 0; row < 3; ++row) {
      text += fmt::format("  {} {}\n", row == 0 ? "K =" : "   ", in_words<Rational>(Vector3<Rational>(k.row(row))));
    }
  }
  return text;
}

std::string truth_steps(const oracles::ExactCase& exact_case, Law law) {
  const ContactState approach = exact_case.state();
  const bool collides = approach == ContactState::colliding;
  return fmt::format("{}, exactly{}\n", carom::name_of(law), collides ? name_of(exact_case.branch(law)) : "") +
         exact_case.with_truth(law, approach, [&]<class T>(const oracles::Truth<T>& truth) {
           const auto lifted = [](double number) { return T(number); };
           return truth_steps<T>(map_numbers<T>(exact_case.collision(), lifted), truth, approach);
         });
}

std::string answers_steps(const oracles::ExactCase& exact_case, const std::vector<oracles::CoulombAnswer>& answers) {
  std::string text;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const oracles::CoulombAnswer& answer = answers[i];
    text += fmt::format("coulomb, answer {} of {}, {}{}\n{}", i + 1, answers.size(), name_of(answer.kind),
                        answer.is_exact() ? ", exactly" : ", with 36 digits of its resistance to slip",
                        truth_steps(exact_case.exact(), answer.truth, exact_case.state()));
  }
  return text;
}

template <class T>
Motion motion_of(const Collision& collision, const Outcome<T>& outcome) {
  const auto exact = map_numbers<T>(collision, [](double x) { return T(x); });
  const Vector3<T> relative = oracles::relative_velocity<T>(exact, outcome);
  Motion motion{map_outcome<double>(outcome, [](const T& x) { return oracles::nearest_double(x); }), {}};
  for (int i = 0; i < 3; ++i) {
    motion.relative_velocity[i] = oracles::nearest_double(relative[i]);
  }
  return motion;
}

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
  shown.record["approach"] = in_words_of(exact_case.state());
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

void add_case_drawing(pugi::xml_node section, const properties::JudgedCase& judged_case, const Answer& answer,
                      Law claimed, const std::string& anchor, const std::string& title) {
  if (!judged_case.is_valid()) {
    add(section, "p", {}, "The collision is invalid, so there is no drawing.");
    return;
  }
  const oracles::ExactCase& exact_case = judged_case.exact();
  const Collision& collision = judged_case.generated().collision;
  ContactPicture picture{collision, motion_of(collision, unchanged(exact_case.exact())), std::nullopt, std::nullopt};
  const auto* computed = std::get_if<ReportedOutcome>(&answer);
  if (computed != nullptr && oracles::is_finite(*computed)) {
    picture.computed = motion_of(collision, oracles::lift(*computed));
  }
  if (claimed == Law::coulomb) {
    const std::vector<oracles::CoulombAnswer> answers = oracles::coulomb_answers(exact_case);
    const bool is_finite = computed != nullptr && oracles::is_finite(*computed);
    const std::size_t nearest = is_finite ? oracles::nearest_answer(exact_case, answers, *computed).number : 0;
    picture.exact = motion_of(collision, answers[nearest].truth.outcome);
  } else if (determines_outcome(claimed)) {
    exact_case.with_truth(claimed, exact_case.state(),
                          [&](const auto& truth) { picture.exact = motion_of(collision, truth.outcome); });
  }
  add_contact_figure(section, picture, anchor, title);
}

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
