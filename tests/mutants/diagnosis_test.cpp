// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>

#include "io/threads.hpp"
#include "known_defects.hpp"
#include "planted_together.hpp"

/// The gate's diagnosis of a planted defect, for every row of the table in docs/reference/diagnoses.md.
namespace carom::mutants {
namespace {

using properties::diagnosis::Diagnosis;

/// The diagnosis of each mutant of the page, from one run. Relations are judged on every fourth case, as for programs.
/// Some mutants remember the last collision, so one thread judges all cases in order.
std::vector<Diagnosis> diagnoses(const std::vector<KnownDefect>& known) {
  properties::GateOptions options;
  options.shrinks = false;
  options.relations_every = 4;
  for (const properties::Family& family : properties::all_families()) {
    options.families.push_back(&family);
  }
  std::vector<Subject> subjects;
  for (const KnownDefect& row : known) {
    subjects.push_back(subject_of(*row.mutant));
  }
  properties::GateReport report = run_gate(subjects, options);
  report.options.workers = tool::threads(0);
  return properties::diagnosis::diagnose_all(report);
}

TEST(Diagnosis, SaysOfEachPlantedDefectWhatThePageSays) {
  const std::vector<KnownDefect> known = known_defects();
  ASSERT_GT(known.size(), 20U) << "the table of the page was not found";
  const std::vector<Diagnosis> found = diagnoses(known);
  for (std::size_t s = 0; s < known.size(); ++s) {
    const std::string name(known[s].mutant->name);
    ASSERT_FALSE(found[s].faults.empty()) << name;
    const properties::diagnosis::Fault& fault = found[s].faults[0];
    EXPECT_EQ(found[s].faults.size(), 1U) << name << ", also: " << found[s].faults.back().what;
    const std::string text = fault.what + ' ' + fault.where + " Look at: " + fault.look_at;
    EXPECT_EQ(missing_part(text, known[s].says), "") << name << ": " << text;
  }
}

/// Solvers with two and with three of the known defects. A defect may be invisible: another one overwrites its effect.
TEST(Diagnosis, NamesTheDefectsThatArePlantedTogether) {
  constexpr std::uint64_t seed = 1;
  const std::vector<KnownDefect> known = known_defects();
  const std::vector<const KnownDefect*> frequent = frequent_defects(known);
  ASSERT_GE(frequent.size(), 30U);
  struct Sets {
    std::size_t size;
    std::size_t count;
    int least_complete;
  };
  for (const auto& [size, count, least_complete] : {Sets{2, 30, 27}, Sets{3, 10, 7}}) {
    int complete = 0;
    std::string others;
    for (const Told& told : told_of(drawn_together(frequent, size, count, seed))) {
      const bool is_complete = told.named.size() == size;
      complete += is_complete ? 1 : 0;
      others += is_complete ? "" : names_of(told.planted) + "; named: " + names_of(told.named) + '\n';
    }
    EXPECT_GE(complete, least_complete) << "of " << count << "; the others are\n" << others;
  }
}

}  // namespace
}  // namespace carom::mutants
