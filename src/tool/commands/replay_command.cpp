// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/numbers/norm.hpp>
#include <carom/properties/domains/draw_within.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/trial/declared_effects.hpp>
#include <carom/properties/trial/in_words.hpp>
#include <carom/report/model/answer_json.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/family_argument.hpp"
#include "io/input_file.hpp"
#include "io/interrupt.hpp"
#include "io/json_file.hpp"
#include "io/orphans.hpp"
#include "io/replay_subjects.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

struct ReplayArguments {
  std::string file;               // empty if a case of a family is replayed
  bool drawn = false;             // whether to replay the drawn collision of a witness
  std::string family;             // the family whose case is replayed in place of a file
  std::uint64_t case_number = 0;  // in the family
  std::uint64_t seed = 1;
  std::optional<properties::Domain> within = {};  // of the case
  std::string subject;                            // empty: the one that a witness names
  double timeout = 5;                             // for each reply of a program [s]
  YardstickArguments judged;
  bool shows_all_laws = false;  // whether to show laws that the subject does not claim
  std::string format = "text";
};

using nlohmann::json;
using oracles::Approach;
using oracles::Rational;
using properties::in_words;

const char* name_of(Approach approach) {
  switch (approach) {
    case Approach::colliding:
      return "colliding";
    case Approach::resting:
      return "resting";
    case Approach::separating:
      return "separating";
    case Approach::inert:
      break;
  }
  return "both bodies are immovable";
}

std::string joined(const std::vector<const properties::Feature*>& features) {
  std::string text;
  for (const properties::Feature* feature : features) {
    text += (text.empty() ? "" : ", ") + feature->name;
  }
  return text;
}

/// The steps of the exact solution that are the same under every law.
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
      in_words(normal_velocity), name_of(exact_case.approach()),
      length == 1 || normal_velocity == 0 ? ""
                                          : fmt::format(", at {:.3g} m/s along the normal",
                                                        std::abs(oracles::nearest_double(normal_velocity)) / length));
  if (exact_case.approach() != Approach::inert) {
    text += fmt::format("  λ = {}\n", in_words(oracles::inverse_mass(c)));
    for (int row = 0; row < 3; ++row) {
      text += fmt::format("  {} {}\n", row == 0 ? "K =" : "   ", in_words<Rational>(Vector3<Rational>(k.row(row))));
    }
  }
  return text;
}

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
std::string truth_steps(const BasicCollision<T>& c, const oracles::Truth<T>& truth, Approach approach) {
  const Vector3<T> after = oracles::relative_velocity<T>(c, truth.outcome);
  std::string text = fmt::format("  F = {}\n", in_words(truth.impulse));
  const auto parts = vectors(truth.outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    text += fmt::format("  {}⁺ = {}\n", carom::name_of(k), in_words(*parts[k]));
  }
  text += fmt::format("  V⁺ = {}\n  N·V⁺ = {}\n", in_words(after), in_words(T(c.normal.dot(after))));
  if (approach != Approach::inert) {
    const auto energy = oracles::equation::Energy{}(c, truth.outcome);
    text += fmt::format("  E⁺ − E⁻ − W = {}\n", in_words(T(energy.left[0] - energy.right[0])));
  }
  return text;
}

std::string truth_steps(const oracles::ExactCase& exact_case, Law law) {
  const Approach approach = exact_case.approach();
  const bool collides = approach == Approach::colliding;
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
                        truth_steps(exact_case.exact(), answer.truth, exact_case.approach()));
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

/// The case that the gate draws from the family with this seed and number.
ReadCollision numbered_case(const ReplayArguments& arguments) {
  const properties::Family& family = family_from_argument("--family", arguments.family);
  return {fmt::format("{} #{} of seed {}", family.name, arguments.case_number, arguments.seed),
          properties::drawn_case_within(arguments.within.value_or(properties::Domain()), family, arguments.seed,
                                        arguments.case_number),
          std::nullopt};
}

struct Shown {
  json record;
  std::string text;
};

/// The law that the judged subject claims. If no subject is judged, the law of the witness, otherwise `any`.
Law claimed_law(const ReadCollision& read, const ReplaySubject* open) {
  if (open != nullptr) {
    return open->subject().law;
  }
  return read.witness && read.witness->law ? *read.witness->law : Law::any;
}

/// Adds the exact outcome under the law, or under each law for `any`. Returns the answers of `coulomb` if it is shown.
/// Precondition: the case is valid.
std::vector<oracles::CoulombAnswer> show_truth(const Collision& collision, const properties::JudgedCase& judged_case,
                                               Law shown_law, Shown& shown) {
  const oracles::ExactCase& exact_case = judged_case.exact();
  const std::vector<const properties::Feature*> features = properties::features_of(collision);
  shown.record["approach"] = name_of(exact_case.approach());
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
    shown.record["truth"][std::string(carom::name_of(law))] = report::truth_record(exact_case, law);
    shown.text += truth_steps(exact_case, law);
  }
  if (!is_shown(Law::coulomb)) {
    return {};
  }
  std::vector<oracles::CoulombAnswer> answers = oracles::coulomb_answers(exact_case);
  shown.record["answers"]["coulomb"] = report::answers_record(answers);
  shown.text += answers_steps(exact_case, answers);
  return answers;
}

void show_judgement(const ReplaySubject& open, const ReplayedCase& replayed, Shown& shown) {
  const Subject& subject = open.subject();
  const auto& claim = open.claim();
  const properties::Judgement& judgement = replayed.judgement;
  json& record = shown.record;
  record["subject"] = subject.name;
  record["yardstick"] = report::Json<oracles::Yardstick>::write(claim.yardstick);
  record["outcome"] = report::Json<Answer>::write(replayed.answer);
  if (judgement.accuracy) {
    record["backward_error_ulps"] =
        judgement.accuracy->is_decided
            ? number_to_json(judgement.accuracy->backward_error(claim.yardstick.unit_roundoff))
            : json();
  }
  for (const properties::NamedVerdict& named : judgement.verdicts) {
    record["verdicts"][std::string(named.invariant->name)] = report::Json<properties::Verdict>::write(named.verdict);
  }
  if (replayed.spellings > 0) {
    record["spellings"] = replayed.spellings;
    record["violated_spellings"] = replayed.violated_spellings;
    record["spelt"] = replayed.spelt;
  }
  if (replayed.violated_spellings > 0 && replayed.violated_spellings < replayed.spellings) {
    shown.text += fmt::format("  violated in {} of {} spellings of the request, first in {}\n",
                              replayed.violated_spellings, replayed.spellings, replayed.spelt);
  }
  shown.text +=
      fmt::format("{}, judged{}\n{}", subject.name, claim.yardstick.filtered ? "" : " only in exact arithmetic",
                  judgement_text(judgement, replayed.answer, claim.yardstick.unit_roundoff));
}

/// Shows the collision. Returns whether the subject violates an invariant on it.
bool replay_one(const ReadCollision& read, const ReplayArguments& arguments, ReplaySubjects& subjects) {
  Shown shown{{{"place", read.place}, {"collision", collision_to_json(read.one.collision)}},
              fmt::format("{}\n{}", read.place, in_words(read.one.collision, "  "))};
  ReplaySubject* const open = subjects.subject_for(read);
  const DeclaredEffects effects = open != nullptr ? open->subject().effects : DeclaredEffects{};
  const properties::JudgedCase judged_case(read.one, !arguments.judged.exact, effects);
  std::vector<oracles::CoulombAnswer> answers;
  if (const std::string declared = properties::to_text(effects); !declared.empty()) {
    shown.text += fmt::format("  {} declares {}; the exact outcome is the law's, before damping and limits of speeds\n",
                              open->subject().name, declared);
  }
  if (judged_case.is_valid()) {
    answers = show_truth(read.one.collision, judged_case, arguments.shows_all_laws ? Law::any : claimed_law(read, open),
                         shown);
  } else {
    shown.text += "  an invalid collision: it has no exact outcome, and a subject must refuse it\n";
  }
  bool violated = false;
  if (open != nullptr) {
    const ReplayedCase replayed = open->judge(read.one);
    violated = is_violated(replayed.judgement);
    show_judgement(*open, replayed, shown);
    if (open->subject().law == Law::coulomb && judged_case.is_valid()) {
      shown.text += nearest_answer_text(judged_case.exact(), replayed.answer, answers);
    }
  }
  if (const std::string why_none = subjects.why_none(read); !why_none.empty()) {
    shown.record["not_judged"] = why_none;
    shown.text += "  " + why_none + '\n';
  }
  if (arguments.format == "json") {
    fmt::print("{}\n", shown.record.dump(-1, ' ', false, json::error_handler_t::replace));
  } else {
    fmt::print("{}\n", printable(shown.text, shown.text.size()));
  }
  return violated;
}

int replay(const ReplayArguments& arguments) {
  const std::stop_token stop = stop_on_interrupt();
  const Orphanage orphanage;
  ReplaySubjects subjects(arguments.subject, arguments.timeout, arguments.judged.yardstick(),
                          arguments.within.value_or(properties::Domain()), stop);
  bool violated = false;
  const auto visit = [&](const ReadCollision& read) {
    if (stop.stop_requested()) {
      throw UsageError(fmt::format("stopped by the user before {}", read.place));
    }
    violated = replay_one(read, arguments, subjects) || violated;
  };
  if (!arguments.family.empty()) {
    visit(numbered_case(arguments));
  } else {
    JsonFile file(arguments.file, stop);
    for_each_collision(file, OutOfRange::refused, visit, arguments.drawn ? OfWitness::drawn : OfWitness::shrunk);
  }
  subjects.close();
  return violated ? exit_violated : exit_all_hold;
}

}  // namespace

void add_replay(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command =
      app.add_subcommand("replay", "Show each step of the exact outcome of collisions, and judge a subject on them");
  CLI::Option* replayed_file =
      command->add_option("FILE", arguments->file, "Witnesses or collisions: JSON Lines, one object or an array");
  command->add_flag("--drawn", arguments->drawn, "Use the collision of a witness as it was drawn, before shrinking")
      ->needs(replayed_file);
  CLI::Option* replayed_family =
      command->add_option("--family", arguments->family, "The family of a case, in place of FILE")
          ->excludes(replayed_file);
  CLI::Option* replayed_case =
      command->add_option("--case", arguments->case_number, "The number of the case, from 0; needs --family")
          ->check(is_count);
  replayed_case->needs(replayed_family);
  replayed_family->needs(replayed_case);
  command->add_option("--seed", arguments->seed, "The seed of the case; needs --family")
      ->check(is_count)
      ->capture_default_str()
      ->needs(replayed_family);
  add_domain_option(*command, "--within", arguments->within,
                    "The domain into which the case was drawn (default: everything); needs --family")
      ->needs(replayed_family);
  command->add_option("--subject", arguments->subject,
                      "Subject to judge (default: the subject of the witness, unless it is a program)");
  command->add_flag("--all-laws", arguments->shows_all_laws,
                    "Show the outcome of every law, not only of the law that the subject claims");
  add_yardstick(*command, arguments->judged);
  add_timeout(*command, arguments->timeout);
  add_format(*command, arguments->format, {"text", "json"});
  command->callback([&chosen, arguments] {
    if (arguments->file.empty() && arguments->family.empty()) {
      throw CLI::RequiredError("FILE, or --family and --case");
    }
    chosen = [arguments] { return replay(*arguments); };
  });
}

}  // namespace carom::tool
