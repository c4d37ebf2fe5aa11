// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>

#include "catalogue.hpp"
#include "io/threads.hpp"

/// The gate's diagnosis of a planted defect, for every row of the table in docs/reference/diagnoses.md.
namespace carom::mutants {
namespace {

using properties::diagnosis::Diagnosis;

struct Row {
  std::string mutant;
  std::string says;  // parts of the diagnosis, separated by …; the diagnosis contains them in this order
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The rows "| `MUTANT`: SENTENCE | SAYS |" of the page.
std::vector<Row> rows_of_the_page() {
  std::ifstream page(CAROM_DIAGNOSES_PAGE);
  std::vector<Row> rows;
  for (std::string line; std::getline(page, line);) {
    const std::size_t name_end = line.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", 3);
    if (!line.starts_with("| `") || name_end == std::string::npos || line.substr(name_end, 2) != "`:") {
      continue;
    }
    const std::size_t bar = line.find('|', name_end);
    rows.push_back({line.substr(3, name_end - 3), trimmed(line.substr(bar + 1, line.rfind('|') - bar - 1))});
  }
  return rows;
}

const Mutant& planted(const std::string& name) {
  const auto found =
      std::find_if(all_mutants().begin(), all_mutants().end(), [&](const Mutant& one) { return one.name == name; });
  if (found == all_mutants().end()) {
    throw std::invalid_argument("there is no mutant " + name);
  }
  return *found;
}

/// The diagnosis of each mutant of the page, from one run. Relations are judged on every fourth case, as for programs.
std::map<std::string, Diagnosis> diagnoses() {
  properties::GateOptions options;
  options.shrinks = false;
  options.relations_every = 4;
  options.workers = tool::threads(0);
  for (const properties::Family& family : properties::all_families()) {
    options.families.push_back(&family);
  }
  std::vector<Subject> subjects;
  for (const Row& row : rows_of_the_page()) {
    subjects.push_back(subject_of(planted(row.mutant)));
  }
  const properties::GateReport report = run_gate(subjects, options);
  const std::vector<Diagnosis> all = properties::diagnosis::diagnose_all(report);
  std::map<std::string, Diagnosis> by_name;
  for (std::size_t s = 0; s < all.size(); ++s) {
    by_name[rows_of_the_page()[s].mutant] = all[s];
  }
  return by_name;
}

TEST(Diagnosis, SaysOfEachPlantedDefectWhatThePageSays) {
  const std::vector<Row> rows = rows_of_the_page();
  ASSERT_GT(rows.size(), 20U) << "the table of the page was not found";
  std::map<std::string, Diagnosis> found = diagnoses();
  for (const Row& row : rows) {
    const Diagnosis& diagnosis = found[row.mutant];
    const std::string text = diagnosis.what + ' ' + diagnosis.where + " Look at: " + diagnosis.look_at;
    std::size_t place = 0;
    for (std::size_t begin = 0; begin <= row.says.size();) {
      const std::string mark = "…";
      const std::size_t end = std::min(row.says.find(mark, begin), row.says.size());
      const std::string part = trimmed(row.says.substr(begin, end - begin));
      place = part.empty() ? place : text.find(part, place);
      EXPECT_NE(place, std::string::npos) << row.mutant << ": '" << part << "' is not in: " << text;
      if (place == std::string::npos) {
        break;
      }
      begin = end + mark.size();
    }
  }
}

}  // namespace
}  // namespace carom::mutants
