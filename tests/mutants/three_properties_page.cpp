// SPDX-License-Identifier: BSL-1.0
#include "three_properties_page.hpp"

#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/properties/gate/gate.hpp>
#include <carom/properties/invariants/invariant.hpp>

#include "io/threads.hpp"
#include "one_property_broken.hpp"

namespace carom::mutants {
namespace {

using properties::Property;

std::string in_code(std::string_view name) { return fmt::format("`{}`", name); }

template <class Names>
std::string listed(const Names& names) {
  std::vector<std::string> all;
  for (const auto& name : names) {
    all.push_back(in_code(name));
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

std::string theorems_in_words(std::string_view invariant) {
  std::vector<std::string> all;
  for (const properties::Theorem& theorem : properties::invariant_named(invariant)->proof.theorems) {
    all.push_back(fmt::format("[`{}`](../../properties/proofs/{})", theorem.name, theorem.file));
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

/// "3 of 40": violated cases of judged cases.
std::string share(std::uint64_t violated, std::uint64_t judged) { return fmt::format("{} of {}", violated, judged); }

struct Marks {
  std::size_t begin;  // of the text between the markers
  std::size_t end;
};

Marks marks_of(const std::string& page, std::string_view name) {
  const std::string first = fmt::format("<!-- begin {} -->\n", name);
  const std::string last = fmt::format("<!-- end {} -->", name);
  const std::size_t begin = page.find(first);
  const std::size_t end = page.find(last);
  if (begin == std::string::npos || end == std::string::npos || end < begin + first.size()) {
    throw std::invalid_argument(fmt::format("the page has no section {}", name));
  }
  return {begin + first.size(), end};
}

std::string cell_of(const nlohmann::json& subject, std::string_view invariant) {
  for (const nlohmann::json& name : subject.at("not_claimed")) {
    if (name == invariant) {
      return "shows no C";
    }
  }
  std::uint64_t violated = 0;
  std::uint64_t judged = 0;
  for (const nlohmann::json& family : subject.at("families")) {
    const nlohmann::json& counts = family.at("invariants");
    if (const auto found = counts.find(std::string(invariant)); found != counts.end()) {
      violated += found->at("violated").get<std::uint64_t>();
      judged += found->at("violated").get<std::uint64_t>() + found->at("holds").get<std::uint64_t>();
    }
  }
  return judged == 0 ? "not judged" : share(violated, judged);
}

}  // namespace

std::string facts_section(const Property& property) {
  std::string text = fmt::format("**Statement.** {}\n\n", property.statement);
  text += "| invariant in the gate | what it says | theorems |\n| --- | --- | --- |\n";
  for (const std::string_view name : property.invariants) {
    const properties::Invariant* invariant = properties::invariant_named(name);
    text += fmt::format("| [`{0}`](../reference/invariants.md#{0}) | {1} | {2} |\n", name, invariant->statement,
                        theorems_in_words(name));
  }
  return text + "\n**Random test.** `EverySolver`, in `tests/properties/conformance/three_properties_test.cpp`.\n";
}

std::string planted_section(const Property& property, const PlantedRun& run) {
  properties::GateOptions options;
  options.seed = run.seed;
  options.cases = run.cases;
  options.workers = tool::threads(run.jobs);
  options.shrinks = false;
  for (const properties::Family& family : properties::all_families()) {
    options.families.push_back(&family);
  }
  std::vector<const BrokenProperty*> defects;
  std::vector<Subject> subjects;
  for (const BrokenProperty& defect : broken_properties()) {
    if (defect.property == property.name) {
      defects.push_back(&defect);
      subjects.push_back(defect.subject());
    }
  }
  const properties::GateReport report = properties::run_gate(subjects, options);
  std::string text = "| planted defect | not claimed | rejected by | violated cases |\n| --- | --- | --- | --- |\n";
  for (std::size_t i = 0; i < defects.size(); ++i) {
    const properties::SubjectResult& result = report.results[i];
    std::vector<std::string> counts;
    for (const properties::Invariant* invariant : result.violated_invariants()) {
      const properties::Count count = result.count(*invariant);
      counts.push_back(share(count.violated, count.violated + count.holds));
    }
    text += fmt::format("| `{}`: {} | {} | {} | {} |\n", defects[i]->name, defects[i]->sentence,
                        subjects[i].deviates.empty() ? "–" : listed(subjects[i].deviates),
                        listed(names_of(result.violated_invariants())), fmt::join(counts, "; "));
  }
  return text;
}

std::string engines_section(const Property& property, const nlohmann::json& report) {
  std::string text = "| engine | law |";
  std::string line = "| --- | --- |";
  for (const std::string_view name : property.invariants) {
    text += fmt::format(" {} |", in_code(name));
    line += " --- |";
  }
  text += '\n' + line + '\n';
  for (const nlohmann::json& subject : report.at("subjects")) {
    if (subject.at("status") == "absent") {
      continue;
    }
    text += fmt::format("| {} {} | {} |", subject.at("name").get<std::string>(), subject.value("version", ""),
                        subject.at("model").get<std::string>());
    for (const std::string_view name : property.invariants) {
      text += fmt::format(" {} |", cell_of(subject, name));
    }
    text += '\n';
  }
  return text;
}

std::string with_section(const std::string& page, std::string_view name, const std::string& text) {
  const Marks marks = marks_of(page, name);
  return page.substr(0, marks.begin) + text + page.substr(marks.end);
}

std::string section_of(const std::string& page, std::string_view name) {
  const Marks marks = marks_of(page, name);
  return page.substr(marks.begin, marks.end - marks.begin);
}

}  // namespace carom::mutants
