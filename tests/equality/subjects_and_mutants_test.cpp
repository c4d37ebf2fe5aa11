// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/subjects/catalogue.hpp>

#include "mutants/catalogue.hpp"
#include "on_families.hpp"
#include "support/effort.hpp"

/// On the built-in subjects and the mutants, the filters change no verdict of rational arithmetic. The program
/// `judge_equality` compares any number of cases.
namespace carom::equality {
namespace {

TEST(JudgeEquality, OfBuiltInSubjects) {
  std::vector<Examined> examined;
  for (const Subject& subject : subjects::all_subjects()) {
    if (subject.absent.empty()) {
      examined.emplace_back(subject);
    }
  }
  constexpr int full = 50;
  const std::uint64_t cases = unit::effort(full) == full ? full : 1;  // all subjects together take 0.2 s for a case
  Agreement agreement;
  compare_on_families(examined, cases, Relations::judged, agreement);
  EXPECT_EQ(joined(agreement), "");
  EXPECT_GT(agreement.verdicts, 10000U);
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    const bool is_of_session = std::holds_alternative<properties::AboutSession>(invariant.about);
    EXPECT_EQ(agreement.invariants.contains(std::string(invariant.name)), !is_of_session) << invariant.name;
  }
}

TEST(JudgeEquality, OfMutants) {
  std::vector<Examined> examined;
  for (const mutants::Mutant& mutant : mutants::all_mutants()) {
    examined.emplace_back(mutants::subject_of(mutant));
  }
  Agreement agreement;
  compare_on_families(examined, 1, Relations::left_out, agreement);
  EXPECT_EQ(joined(agreement), "");
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    const bool is_relation = invariant.asks() || std::holds_alternative<properties::AboutSession>(invariant.about);
    EXPECT_EQ(agreement.invariants.contains(std::string(invariant.name)), !is_relation) << invariant.name;
  }
}

}  // namespace
}  // namespace carom::equality
