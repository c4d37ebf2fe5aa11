// SPDX-License-Identifier: BSL-1.0
#include "merge/read_shard.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>

#include "commands/commands.hpp"
#include "commands/json_file.hpp"
#include "compare/field.hpp"
#include "compare/read_report.hpp"
#include "merge/findings.hpp"
#include "merge/read_witness.hpp"
#include "version.hpp"

namespace carom::tool::merge {
namespace {

namespace fs = std::filesystem;
using compare::Field;
using compare::shown;

std::vector<std::string> texts_of(const Field& list) {
  std::vector<std::string> texts;
  for (const Field& element : list.elements()) {
    texts.push_back(element.text());
  }
  return texts;
}

std::string optional_text(const Field& record, const char* name) {
  const std::optional<Field> field = record.find(name);
  return field ? field->text() : "";
}

unsigned threads_of(const Field& field) {
  constexpr std::uint64_t most = 1U << 20U;
  if (field.count() > most) {
    field.fail("a number of threads");
  }
  return static_cast<unsigned>(field.count());
}

Environment environment_from(const Field& record) {
  Environment environment;
  environment.date = record.at("date").text();
  environment.compiler = record.at("compiler").text();
  for (const auto& [library, flags] : record.at("compiler_flags").members()) {
    environment.compiler_flags[library] = flags.text();
  }
  environment.build_type = record.at("build_type").text();
  environment.operating_system = record.at("operating_system").text();
  environment.kernel = record.at("kernel").text();
  environment.processor = record.at("processor").text();
  environment.processor_threads = threads_of(record.at("processor_threads"));
  return environment;
}

oracles::Yardstick yardstick_from(const Field& record) {
  oracles::Yardstick yardstick;
  yardstick.limit_ulps = record.at("limit_ulps").number();
  if (const std::optional<Field> digits = record.find("digits")) {
    constexpr std::uint64_t most = 18;
    if (digits->count() < 1 || digits->count() > most) {
      digits->fail("a number from 1 to 18");
    }
    yardstick.digits = static_cast<int>(digits->count());
  }
  const std::optional<Field> exact = record.find("exact");
  yardstick.filtered = !(exact && exact->flag());
  return yardstick;
}

const properties::Family* family_from(const Field& name) {
  const properties::Family* family = properties::family_named(name.text());
  if (family == nullptr) {
    name.fail("the name of a family");
  }
  return family;
}

const properties::Family* family_beyond_domain_from(const Field& name) {
  const properties::Family* family = family_from(name);
  if (!family->is_beyond_domain()) {
    name.fail("the name of a family beyond the claimed domain");
  }
  return family;
}

std::string invariant_from(const Field& place, const std::string& name) {
  if (properties::invariant_named(name) == nullptr) {
    place.fail("the name of an invariant");
  }
  return name;
}

properties::Shard shard_from(const Field& record) {
  const properties::Shard shard{record.at("number").count(), record.at("of").count()};
  if (shard.number < 1 || shard.number > shard.of) {
    record.at("number").fail("a number from 1 to that of the shards");
  }
  return shard;
}

properties::GateOptions options_from(const Field& record) {
  properties::GateOptions options;
  options.seed = record.at("seed").count();
  options.cases = record.at("cases_of_each_family").count();
  options.yardstick = yardstick_from(record.at("yardstick"));
  if (const std::optional<Field> every = record.find("relations_every")) {
    options.relations_every = every->count();
  }
  for (const Field& family : record.at("families").elements()) {
    options.families.push_back(family_from(family.at("name")));
  }
  if (const std::optional<Field> beyond = record.find("beyond_domain")) {
    for (const Field& family : beyond->elements()) {
      options.beyond_domain.push_back(family_beyond_domain_from(family.at("name")));
    }
  }
  options.shard = shard_from(record.at("shard"));
  return options;
}

properties::Coverage coverage_from(const Field& record) {
  properties::Coverage coverage;
  coverage.cases = record.at("cases").count();
  coverage.colliding = record.at("colliding").count();
  coverage.resting = record.at("resting").count();
  coverage.separating = record.at("separating").count();
  coverage.inert = record.at("inert").count();
  coverage.invalid = record.at("invalid").count();
  coverage.one_immovable = record.at("one_immovable").count();
  coverage.spheres = record.at("spheres").count();
  coverage.head_on = record.at("head_on").count();
  coverage.inelastic = record.at("inelastic").count();
  coverage.elastic = record.at("elastic").count();
  const Field adjusted = record.at("adjusted");
  for (const properties::Adjustment adjustment : properties::all_adjustments) {
    coverage.adjusted[adjustment] = adjusted.at(std::string(name_of(adjustment))).count();
  }
  return coverage;
}

properties::FeatureCoverage features_from(const Field& record) {
  const auto all = properties::all_features();
  std::map<std::string, const properties::Feature*> by_name;
  std::vector<std::uint64_t> counts;
  const Field cases = record.at("cases");
  for (const properties::Feature& feature : all) {
    by_name.emplace(feature.name, &feature);
    counts.push_back(cases.at(std::string(feature.name)).count());
  }
  std::vector<properties::FeatureCoverage::Pair> missing;
  for (const Field& pair : record.at("missing_pairs").elements()) {
    const std::vector<std::string> names = texts_of(pair);
    if (names.size() != 2 || !by_name.contains(names[0]) || !by_name.contains(names[1])) {
      pair.fail("the names of two features");
    }
    missing.push_back({by_name.at(names[0]), by_name.at(names[1])});
  }
  return properties::FeatureCoverage::reported(std::move(counts), missing);
}

Subject subject_from(const Field& record) {
  Subject subject;
  subject.name = record.at("name").text();
  subject.summary = record.at("summary").text();
  const std::optional<Model> model = model_named(record.at("model").text());
  if (!model) {
    record.at("model").fail("the name of a law");
  }
  subject.model = *model;
  const std::string precision = record.at("precision").text();
  constexpr std::array all{Precision::binary32, Precision::binary64, Precision::extended};
  const auto found = std::find_if(all.begin(), all.end(), [&](Precision one) { return name_of(one) == precision; });
  if (found == all.end()) {
    record.at("precision").fail("the name of a precision");
  }
  subject.precision = *found;
  subject.expected_to_pass = record.at("expected_to_pass").flag();
  subject.deviates = texts_of(record.at("deviates"));
  subject.shows_collision_matrix = record.at("shows_collision_matrix").flag();
  subject.specification = optional_text(record, "specification");
  subject.version = optional_text(record, "version");
  return subject;
}

properties::UnjudgedCounts unjudged_from(const Field& record) {
  properties::UnjudgedCounts counts{};
  for (const properties::Unjudged reason : properties::all_reasons_unjudged) {
    counts[reason] = record.at(std::string(properties::name_of(reason))).count();
  }
  return counts;
}

properties::FamilyResult family_result_from(const Field& record, const properties::Family& expected) {
  if (record.at("family").text() != expected.name) {
    record.at("family").fail(fmt::format("\"{}\"", expected.name));
  }
  properties::FamilyResult result;
  result.cases = record.at("cases").count();
  result.skipped = record.at("skipped").count();
  result.unjudged = unjudged_from(record.at("not_judged"));
  result.violated = record.at("violated").count();
  result.worst_backward_error = record.at("worst_backward_error_ulps").number();
  for (const auto& [name, count] : record.at("invariants").members()) {
    result.counts[invariant_from(count, name)] = {count.at("holds").count(), count.at("violated").count(),
                                                  count.at("skipped").count()};
  }
  return result;
}

/// Of a subject that was judged beyond the claimed domain; empty for others.
std::vector<properties::FamilyResult> beyond_domain_from(const Field& subject,
                                                         const std::vector<const properties::Family*>& expected) {
  std::vector<properties::FamilyResult> results;
  const std::optional<Field> list = subject.find("beyond_domain");
  if (!list) {
    return results;
  }
  for (const Field& record : list->elements()) {
    if (results.size() >= expected.size() || record.at("family").text() != expected[results.size()]->name) {
      record.at("family").fail("the families of the run, in their order");
    }
    properties::FamilyResult& result = results.emplace_back();
    result.cases = record.at("cases").count();
    result.skipped = record.at("skipped").count();
    result.unjudged = unjudged_from(record.at("not_judged"));
    result.violated = record.at("violated").count();
    if (const Field boundary = record.at("boundary"); !boundary.value().is_null()) {
      result.boundary = {boundary.at("quantity").number(), boundary.at("case").count(),
                         invariant_from(boundary.at("invariant"), boundary.at("invariant").text())};
    }
  }
  return results;
}

properties::Histogram<properties::DigitsScale> digits_from(const Field& record) {
  std::vector<std::uint64_t> counts;
  for (const Field& pair : record.at("bins").elements()) {
    const std::vector<Field> numbers = pair.elements();
    if (numbers.size() != 2 || numbers[0].count() >= properties::DigitsScale::bins) {
      pair.fail("a bin and how many are in it");
    }
    counts.resize(std::max<std::size_t>(counts.size(), numbers[0].count() + 1));
    counts[numbers[0].count()] = numbers[1].count();
  }
  const double smallest = record.at("smallest").number();
  const double largest = record.at("largest").number();
  if (!counts.empty() && !(smallest <= largest)) {
    record.fail("a smallest number that is at most the largest");
  }
  return properties::Histogram<properties::DigitsScale>::restored(std::move(counts), smallest, largest);
}

properties::Witness witness_in(const fs::path& directory, const Subject& subject, const Field& violation) {
  properties::Witness listed;
  listed.invariant = invariant_from(violation.at("invariant"), violation.at("invariant").text());
  // No path that a file names is followed.
  const fs::path path = witness_path(directory, subject, listed);
  const std::string content = content_of_file(path.string());
  try {
    const nlohmann::json record = parse_json(content);
    properties::Witness witness = witness_from(Field(record));
    if (witness.invariant != listed.invariant) {
      throw FormatError("/invariant", fmt::format("expected \"{}\"", listed.invariant));
    }
    return witness;
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}", shown(path.string()), shown(error.what())));
  }
}

void read_findings_of_families(const Field& findings, const properties::GateOptions& options,
                               std::vector<properties::FamilyResult>& into) {
  for (std::size_t f = 0; f < into.size(); ++f) {
    const properties::Family& family = *options.families[f];
    into[f].sampled = properties::sampled_of(family);
    const auto& counts = into[f].counts;
    if (std::any_of(counts.begin(), counts.end(), [](const auto& of_name) { return of_name.second.violated > 0; })) {
      read_findings(
          findings.at(std::string(family.name)), options.cases * static_cast<std::uint64_t>(family.weight),
          [&](std::uint64_t number) { return properties::drawn_case(family, options.seed, number); }, into[f]);
    }
  }
}

properties::SubjectResult result_from(const Field& record, const Field& digits, const Field& findings,
                                      const properties::GateOptions& options, const fs::path& directory) {
  properties::SubjectResult result;
  result.subject = subject_from(record);
  if (record.at("status").text() == "error") {
    result.error = record.at("error").text();
  }
  const std::vector<Field> families = record.at("families").elements();
  if (families.size() != options.families.size()) {
    record.at("families").fail(fmt::format("{} families", options.families.size()));
  }
  for (std::size_t f = 0; f < families.size(); ++f) {
    result.families.push_back(family_result_from(families[f], *options.families[f]));
  }
  read_findings_of_families(findings, options, result.families);
  result.beyond_domain = beyond_domain_from(record, options.beyond_domain);
  result.error_beyond_domain = optional_text(record, "error_beyond_domain");
  result.digits = digits_from(digits);
  result.nanoseconds_per_solve = record.at("nanoseconds_per_solve").number();
  for (const Field& violation : record.at("violations").elements()) {
    result.witnesses.push_back(witness_in(directory, result.subject, violation));
  }
  return result;
}

GateRun run_from(const Field& record, const fs::path& directory) {
  if (record.at("carom").text() != version) {
    record.at("carom").fail(fmt::format("\"{}\", the version of this program", version));
  }
  if (record.at("interrupted").flag()) {
    record.at("interrupted").fail("a run that was not interrupted");
  }
  if (!record.find("shard")) {
    throw FormatError("/shard", "is missing: the report is of no shard");
  }
  GateRun run;
  run.report.options = options_from(record);
  run.environment = environment_from(record.at("environment"));
  if (const std::optional<Field> deviates = record.find("deviates")) {
    run.deviates = texts_of(*deviates);
  }
  for (const Field& family : record.at("families").elements()) {
    run.report.coverage.push_back(coverage_from(family.at("coverage")));
  }
  run.report.features = features_from(record.at("features"));
  const std::vector<Field> digits = record.at("shard").at("digits").elements();
  const std::vector<Field> findings = record.at("shard").at("findings").elements();
  for (const Field& subject : record.at("subjects").elements()) {
    if (subject.at("status").text() == "absent") {
      run.absent.push_back(subject_from(subject));
      run.absent.back().absent = subject.at("error").text();
      continue;
    }
    if (digits.size() <= run.report.results.size()) {
      record.at("shard").at("digits").fail("an element for each subject that was judged");
    }
    if (findings.size() <= run.report.results.size()) {
      record.at("shard").at("findings").fail("an element for each subject that was judged");
    }
    const std::size_t number = run.report.results.size();
    run.report.results.push_back(result_from(subject, digits[number], findings[number], run.report.options, directory));
    run.counts.push_back(subject.at("counts").flag());
  }
  return run;
}

}  // namespace

ReadShard read_shard(const std::string& directory) {
  const auto [file, record] = compare::parsed_report((fs::path(directory) / "report.json").string());
  try {
    return {file, run_from(Field(record), directory)};
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}", shown(file), shown(error.what())));
  }
}

}  // namespace carom::tool::merge
