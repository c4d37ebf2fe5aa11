// SPDX-License-Identifier: BSL-1.0
#include "compare/read_report.hpp"

#include <cstddef>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/model.hpp>
#include <carom/subjects/protocol/text.hpp>

#include "commands/commands.hpp"
#include "commands/json_file.hpp"
#include "compare/field.hpp"

namespace carom::tool::compare {
namespace {

std::vector<std::string> lines_of(const Field& list) {
  std::vector<std::string> lines;
  for (const Field& element : list.elements()) {
    lines.push_back(element.line());
  }
  return lines;
}

std::string optional_line(const Field& record, const std::string& name) {
  const std::optional<Field> field = record.find(name);
  return field ? field->line() : "";
}

bool optional_flag(const Field& record, const std::string& name) {
  const std::optional<Field> field = record.find(name);
  return field && field->flag();
}

/// Throws where the name stands in the list a second time.
void require_new(std::set<std::string>& names, const Field& name) {
  if (!names.insert(name.line()).second) {
    throw FormatError(name.place(), fmt::format("'{}' stands here twice", name.line()));
  }
}

std::string yardstick_of(const Field& record) {
  const std::optional<Field> digits = record.find("digits");
  const std::string limit =
      digits ? fmt::format("{} digits", digits->count()) : fmt::format("{} ulps", record.at("limit_ulps").number());
  return limit + (optional_flag(record, "exact") ? ", in exact arithmetic alone" : "");
}

ReadFamily family_of(const Field& record, SubjectSummary& summary) {
  ReadFamily family{record.at("family").line(), {}};
  summary.violated_cases += record.at("violated").count();
  for (const auto& [name, count] : record.at("invariants").members()) {
    family.invariants[shown(name)] = {count.at("holds").count(), count.at("violated").count()};
  }
  return family;
}

void read_judged(const Field& record, ReadSubject& subject) {
  SubjectSummary& summary = subject.summary;
  summary.cases = record.at("cases").count();
  const std::optional<Model> model = model_named(summary.model);
  const Field worst = record.at("worst_backward_error");
  if (model && determines_outcome(*model)) {
    summary.worst_backward_error = worst.at("ulps").number();
    summary.worst_family = worst.at("family").line();
  }
  const Field digits = record.at("digits");
  summary.digits_p50 = digits.at("p50").optional_number();
  summary.digits_p99 = digits.at("p99").optional_number();
  summary.digits_worst = digits.at("worst").optional_number();
  std::set<std::string> names;
  for (const Field& family : record.at("families").elements()) {
    require_new(names, family.at("family"));
    subject.families.push_back(family_of(family, summary));
  }
  for (const Field& violation : record.at("violations").elements()) {
    summary.violated.push_back(violation.at("invariant").line());
  }
}

ReadSubject subject_of(const Field& record) {
  ReadSubject subject;
  subject.name = record.at("name").line();
  subject.specification = optional_line(record, "specification");
  subject.counts = record.at("counts").flag();
  SubjectSummary& summary = subject.summary;
  summary.status = record.at("status").line();
  summary.error = record.at("error").line();
  summary.version = optional_line(record, "version");
  summary.model = record.at("model").line();
  summary.precision = record.at("precision").line();
  summary.deviates = lines_of(record.at("deviates"));
  if (const std::optional<Field> not_claimed = record.find("not_claimed")) {
    summary.not_claimed = lines_of(*not_claimed);
  }
  if (summary.status != "absent") {
    read_judged(record, subject);
  }
  return subject;
}

}  // namespace

std::string shown(const std::string& text) {
  constexpr std::size_t longest = 4000;
  return subjects::protocol::printable_line(text, longest);
}

ReadReport report_from_json(const nlohmann::json& json, const std::string& file) {
  const Field record(json);
  ReadReport report;
  report.file = shown(file);
  report.carom = record.at("carom").line();
  report.date = record.at("environment").at("date").line();
  report.seed = record.at("seed").count();
  const Field cases = record.at("cases_of_each_family");
  if (!cases.value().is_null()) {
    report.cases = cases.count();
  }
  if (const std::optional<Field> budget = record.find("budget_seconds")) {
    report.budget = budget->number();
  }
  if (const std::optional<Field> every = record.find("relations_every")) {
    report.relations_every = every->count();
  }
  if (const std::optional<Field> shard = record.find("shard")) {
    report.shard = fmt::format("{}/{}", shard->at("number").count(), shard->at("of").count());
  }
  report.yardstick = yardstick_of(record.at("yardstick"));
  report.fail_fast = optional_flag(record, "fail_fast");
  report.interrupted = record.at("interrupted").flag();
  std::set<std::string> families;
  for (const Field& family : record.at("families").elements()) {
    require_new(families, family.at("name"));
    report.families.push_back(family.at("name").line());
  }
  std::set<std::string> subjects;
  for (const Field& subject : record.at("subjects").elements()) {
    require_new(subjects, subject.at("name"));
    report.subjects.push_back(subject_of(subject));
  }
  return report;
}

ParsedFile parsed_report(const std::string& file_or_directory) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const std::string file = fs::is_directory(file_or_directory, ignored)
                               ? (fs::path(file_or_directory) / "report.json").string()
                               : file_or_directory;
  const std::string content = content_of_file(file);
  try {
    return {file, parse_json(content)};
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}", shown(file), shown(error.what())));
  }
}

ReadReport read_report(const std::string& file_or_directory) {
  const auto [file, record] = parsed_report(file_or_directory);
  try {
    return report_from_json(record, file);
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: is not a report.json of carom gate: {}", shown(file), shown(error.what())));
  }
}

}  // namespace carom::tool::compare
