// SPDX-License-Identifier: BSL-1.0
#include "report/records.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/subjects/protocol/command_line.hpp>

#include "commands/commands.hpp"
#include "compare/comparison_record.hpp"
#include "merge/shard_record.hpp"
#include "report/beyond_domain.hpp"
#include "report/not_claimed.hpp"
#include "version.hpp"

namespace carom::tool {
namespace {

using nlohmann::json;
using oracles::Rational;
using properties::Status;

template <class S, class Convert>
json velocities_record(const Outcome<S>& outcome, const Convert& convert) {
  const auto vector = [&](const Vector3<S>& v) { return json::array({convert(v[0]), convert(v[1]), convert(v[2])}); };
  const auto body = [&](const BodyVelocity<S>& motion) {
    return json{{"velocity", vector(motion.velocity)}, {"angular_velocity", vector(motion.angular_velocity)}};
  };
  return {{"a", body(outcome.a)}, {"b", body(outcome.b)}};
}

json numbers(const std::vector<double>& values) {
  json array = json::array();
  for (const double value : values) {
    array.push_back(number_to_json(value));
  }
  return array;
}

json optional_number(const std::optional<double>& value) { return value ? number_to_json(*value) : json(); }

json coverage_record(const properties::Coverage& coverage) {
  json adjusted = json::object();
  for (const properties::Adjustment adjustment : properties::all_adjustments) {
    adjusted[name_of(adjustment)] = coverage.adjusted[adjustment];
  }
  return {{"cases", coverage.cases},
          {"colliding", coverage.colliding},
          {"resting", coverage.resting},
          {"separating", coverage.separating},
          {"inert", coverage.inert},
          {"invalid", coverage.invalid},
          {"one_immovable", coverage.one_immovable},
          {"spheres", coverage.spheres},
          {"head_on", coverage.head_on},
          {"inelastic", coverage.inelastic},
          {"elastic", coverage.elastic},
          {"adjusted", std::move(adjusted)}};
}

json features_record(const properties::FeatureCoverage& coverage) {
  json record{
      {"feasible_pairs", coverage.feasible_pairs()}, {"missing_pairs", json::array()}, {"cases", json::object()}};
  for (const auto& [x, y] : coverage.missing_pairs()) {
    record["missing_pairs"].push_back({x->name, y->name});
  }
  for (std::size_t i = 0; i < properties::all_features().size(); ++i) {
    record["cases"][properties::all_features()[i].name] = coverage.count(i);
  }
  return record;
}

json count_record(const properties::Count& count) {
  return {{"holds", count.holds}, {"violated", count.violated}, {"skipped", count.skipped}};
}

}  // namespace

json yardstick_record(const oracles::Yardstick& yardstick) {
  json record{{"limit_ulps", yardstick.limit_ulps}};
  if (yardstick.digits) {
    record["digits"] = *yardstick.digits;
  }
  if (!yardstick.filtered) {
    record["exact"] = true;
  }
  return record;
}

json unjudged_record(const properties::UnjudgedCounts& counts) {
  json record = json::object();
  for (const properties::Unjudged reason : properties::all_reasons_unjudged) {
    record[properties::name_of(reason)] = counts[reason];
  }
  return record;
}

std::string status_of(const properties::SubjectResult& result) {
  if (!result.violated_invariants().empty()) {
    return "violated";
  }
  if (!result.error.empty()) {
    return "error";
  }
  return result.is_sound() ? "sound" : "not judged";
}

namespace {

json subject_facts(const Subject& subject) {
  json facts{{"name", subject.name},
             {"summary", subject.summary},
             {"model", name_of(subject.model)},
             {"precision", name_of(subject.precision)},
             {"expected_to_pass", subject.expected_to_pass},
             {"deviates", subject.deviates},
             {"shows_collision_matrix", subject.shows_collision_matrix},
             {"not_claimed", not_claimed_without_matrix(subject)}};
  if (!subject.specification.empty()) {
    facts["specification"] = subject.specification;
  }
  if (!subject.version.empty()) {
    facts["version"] = subject.version;
  }
  return facts;
}

json diagnosis_record(const properties::diagnosis::Diagnosis& diagnosis) {
  return {{"telling", diagnosis.telling}, {"violated", diagnosis.violated}, {"telling_in", diagnosis.telling_in},
          {"what", diagnosis.what},       {"where", diagnosis.where},       {"look_at", diagnosis.look_at}};
}

json subject_record(const properties::SubjectResult& result, const properties::GateOptions& options, bool counts) {
  json record = subject_facts(result.subject);
  record["counts"] = counts;
  record["status"] = status_of(result);
  record["error"] = result.error.empty() ? result.not_judged : result.error;
  record["cases"] = result.cases();
  record["skipped"] = result.skipped();
  record["not_judged"] = unjudged_record(result.unjudged());
  const auto worst = result.worst_backward_error(options);
  record["worst_backward_error"] = {{"ulps", number_to_json(worst.backward_error)}, {"family", worst.family}};
  record["digits"] = {{"p50", optional_number(result.digits_at_least(0.5))},
                      {"p99", optional_number(result.digits_at_least(0.99))},
                      {"worst", optional_number(result.digits_at_least(1))}};
  record["nanoseconds_per_solve"] = result.nanoseconds_per_solve;
  record["families"] = json::array();
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    const properties::FamilyResult& family = result.families[f];
    json invariants = json::object();
    for (const auto& [name, count] : family.counts) {
      invariants[name] = count_record(count);
      if (const auto worst_case = family.worst.find(name); worst_case != family.worst.end()) {
        invariants[name]["worst_case"] = worst_case->second.index;
      }
    }
    record["families"].push_back({{"family", options.families[f]->name},
                                  {"cases", family.cases},
                                  {"skipped", family.skipped},
                                  {"not_judged", unjudged_record(family.unjudged)},
                                  {"violated", family.violated},
                                  {"worst_backward_error_ulps", number_to_json(family.worst_backward_error)},
                                  {"invariants", std::move(invariants)}});
  }
  if (!result.beyond_domain.empty()) {
    record["beyond_domain"] = beyond_domain_record(result, options);
  }
  if (!result.error_beyond_domain.empty()) {
    record["error_beyond_domain"] = result.error_beyond_domain;
  }
  record["violations"] = json::array();
  for (const properties::Witness& witness : result.witnesses) {
    record["violations"].push_back({{"invariant", witness.invariant},
                                    {"count", result.count(witness.invariant).violated},
                                    {"family", witness.family},
                                    {"case", witness.index},
                                    {"witness", witness_path({}, result.subject, witness).string()}});
  }
  return record;
}

}  // namespace

json outcome_record(const ReportedOutcome& outcome) {
  const auto number_record = [](long double number) -> json {
    const auto rounded = static_cast<double>(number);
    const bool is_binary64 = static_cast<long double>(rounded) == number || number != number;
    return is_binary64 ? number_to_json(rounded) : json(fmt::format("{:.21g}", number));
  };
  json record = velocities_record<long double>(outcome, number_record);
  if (outcome.collision_matrix) {
    for (int i = 0; i < 3; ++i) {
      json row = json::array();
      for (int j = 0; j < 3; ++j) {
        row.push_back(number_record((*outcome.collision_matrix)(i, j)));
      }
      record["C"].push_back(std::move(row));
    }
  }
  return record;
}

json answer_record(const Answer& answer) {
  if (const auto* outcome = std::get_if<ReportedOutcome>(&answer)) {
    return outcome_record(*outcome);
  }
  if (const auto* refused = std::get_if<Refused>(&answer)) {
    return {{"refused", refused->why}};
  }
  if (const auto* failed = std::get_if<Failed>(&answer)) {
    return {{"failed", failed->why}, {"said", failed->said}};
  }
  return {{"skipped", std::get<Skipped>(answer).why}};
}

namespace {

template <class T>
json velocities_and_impulse(const oracles::Truth<T>& truth) {
  json record = velocities_record(truth.outcome, [](const T& x) { return oracles::to_text(x); });
  record["impulse"] = json::array();
  for (int i = 0; i < 3; ++i) {
    record["impulse"].push_back(oracles::to_text(truth.impulse[i]));
  }
  return record;
}

template <class T>
json nearest_record(const Outcome<T>& outcome) {
  return velocities_record(outcome, [](const T& x) { return number_to_json(oracles::nearest_double(x)); });
}

}  // namespace

json truth_record(const oracles::ExactCase& exact_case, Model model) {
  return exact_case.with_truth(model, exact_case.approach(), []<class T>(const oracles::Truth<T>& truth) {
    json record = velocities_and_impulse(truth);
    record["nearest"] = nearest_record(truth.outcome);
    return record;
  });
}

json answers_record(std::span<const oracles::CoulombAnswer> answers) {
  json record = json::array();
  for (const oracles::CoulombAnswer& answer : answers) {
    json of_answer = answer.is_exact() ? velocities_and_impulse(answer.truth) : json::object();
    of_answer["kind"] = name_of(answer.kind);
    of_answer["exact"] = answer.is_exact();
    of_answer["nearest"] = nearest_record(answer.truth.outcome);
    record.push_back(std::move(of_answer));
  }
  return record;
}

json verdict_record(const properties::Verdict& verdict) {
  switch (verdict.status) {
    case Status::holds:
      return {{"status", "holds"}};
    case Status::skipped:
      return {{"status", "skipped"}, {"detail", verdict.detail}};
    case Status::violated:
      break;
  }
  return {{"status", "violated"},
          {"detail", verdict.detail},
          {"left", numbers(verdict.left)},
          {"right", numbers(verdict.right)},
          {"residual", number_to_json(verdict.residual)},
          {"allowed", number_to_json(verdict.allowed)}};
}

json witness_record(const properties::Witness& witness, const Subject& subject, const properties::GateOptions& options,
                    const std::filesystem::path& witness_file) {
  const properties::Invariant& invariant = *properties::invariant_named(witness.invariant);
  json record{{"subject", subject_facts(subject)},
              {"invariant", witness.invariant},
              {"statement", invariant.statement},
              {"formula", invariant.formula},
              {"family", witness.family},
              {"seed", options.seed},
              {"case", witness.index},
              {"yardstick", yardstick_record(options.yardstick)},
              {"convex_uniform", witness.shrunk.convex_uniform},
              {"collision", collision_to_json(witness.shrunk.collision)},
              {"drawn", collision_to_json(witness.original.collision)},
              {"outcome", answer_record(witness.answer)},
              {"verdict", verdict_record(witness.verdict)},
              {"drawn_outcome", answer_record(witness.answer_as_found)},
              {"drawn_verdict", verdict_record(witness.verdict_as_found)},
              {"reproduced", witness.is_reproduced},
              {"replay", replay_command(witness_file, subject, options.yardstick)}};
  const properties::JudgedCase judged_case(witness.shrunk);
  if (judged_case.is_valid()) {
    for (const Model model : models_with_truth) {
      if (subject.model == model || subject.model == Model::any) {
        record["truth"][std::string(name_of(model))] = truth_record(judged_case.exact(), model);
      }
    }
    if (subject.model == Model::coulomb) {
      record["answers"]["coulomb"] = answers_record(oracles::coulomb_answers(judged_case.exact()));
    }
  }
  return record;
}

int GateRun::exit_status() const {
  bool judged = false;
  bool violated = false;
  bool ended_early = false;
  bool failed = report.interrupted;
  for (std::size_t s = 0; s < report.results.size(); ++s) {
    if (!counts[s]) {
      continue;
    }
    judged = true;
    const properties::SubjectResult& result = report.results[s];
    const std::string status = status_of(result);
    // What was judged, and then could not be judged to the end, is at fault itself.
    const bool is_at_fault = status == "violated" || (status == "error" && result.cases() > 0);
    violated = violated || is_at_fault;
    ended_early = ended_early || !result.error.empty();
    failed = failed || (status != "sound" && !is_at_fault);
  }
  if (failed || !judged) {
    return exit_usage;
  }
  const bool is_new = baseline ? ended_early || baseline->count_new(true) > 0 : violated;
  return is_new ? exit_violated : exit_all_hold;
}

json report_record(const GateRun& run) {
  const properties::GateOptions& options = run.report.options;
  json record{{"carom", version},
              {"environment", environment_record(run.environment)},
              {"seed", options.seed},
              {"cases_of_each_family", options.budget ? json() : json(options.cases)},
              {"yardstick", yardstick_record(options.yardstick)},
              {"exit_status", run.exit_status()},
              {"interrupted", run.report.interrupted},
              {"families", json::array()},
              {"subjects", json::array()}};
  if (options.budget) {
    record["budget_seconds"] = std::chrono::duration<double>(*options.budget).count();
  }
  if (options.fail_fast) {
    record["fail_fast"] = true;
  }
  if (options.relations_every > 0) {
    record["relations_every"] = options.relations_every;
  }
  if (!run.deviates.empty()) {
    record["deviates"] = run.deviates;
  }
  if (run.is_shard) {
    record["shard"] = merge::shard_record(run.report);
  }
  if (run.baseline) {
    record["baseline"] = compare::baseline_record(*run.baseline);
  }
  for (std::size_t f = 0; f < options.families.size(); ++f) {
    record["families"].push_back({{"name", options.families[f]->name},
                                  {"summary", options.families[f]->summary},
                                  {"coverage", coverage_record(run.report.coverage[f])}});
  }
  if (!options.beyond_domain.empty()) {
    record["beyond_domain"] = beyond_domain_families_record(options);
  }
  record["features"] = features_record(run.report.features);
  for (std::size_t s = 0; s < run.report.results.size(); ++s) {
    record["subjects"].push_back(subject_record(run.report.results[s], options, run.counts[s]));
    if (s < run.diagnoses.size() && !run.diagnoses[s].telling.empty()) {
      record["subjects"].back()["diagnosis"] = diagnosis_record(run.diagnoses[s]);
    }
  }
  for (const Subject& subject : run.absent) {
    json absent = subject_facts(subject);
    absent["counts"] = false;
    absent["status"] = "absent";
    absent["error"] = subject.absent;
    record["subjects"].push_back(std::move(absent));
  }
  return record;
}

std::string file_name_of(std::string name) {
  for (char& letter : name) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' || letter == '.';
    letter = is_plain ? letter : '_';
  }
  return name;
}

std::filesystem::path witness_path(const std::filesystem::path& directory, const Subject& subject,
                                   const properties::Witness& witness) {
  return directory / "witnesses" / (file_name_of(subject.name) + '.' + witness.invariant + ".json");
}

std::string replay_command(const std::filesystem::path& witness_file, const Subject& subject,
                           const oracles::Yardstick& yardstick) {
  std::string command =
      fmt::format("carom replay {} --subject {}", subjects::protocol::quoted(witness_file.string()),
                  subjects::protocol::quoted(subject.specification.empty() ? subject.name : subject.specification));
  if (yardstick.limit_ulps != oracles::default_limit_ulps) {
    command += fmt::format(" --limit-ulps {}", yardstick.limit_ulps);
  }
  if (yardstick.digits) {
    command += fmt::format(" --digits {}", *yardstick.digits);
  }
  if (!yardstick.filtered) {
    command += " --exact";
  }
  return command;
}

}  // namespace carom::tool
