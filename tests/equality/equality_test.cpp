// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/subjects/catalogue.hpp>

#include "agreement.hpp"
#include "mutants/catalogue.hpp"
#include "planted.hpp"
#include "wild.hpp"

/// The filters change no verdict: what they decide is held against the judge in rational numbers alone. The program
/// `judge_equality` does the same on as many cases as there is time for.
namespace carom::equality {
namespace {

constexpr std::uint64_t seed = 4;

std::string joined(const Agreement& agreement) {
  std::string text;
  for (const std::string& difference : agreement.differences) {
    text += difference + '\n';
  }
  return text;
}

/// So many cases of each family, and as many wild ones for each fifth family; each case is worked out once for all
/// subjects.
void compare_on_all(std::span<Examined> examined, std::uint64_t cases, Relations relations, Agreement& agreement) {
  for (const properties::Family& family : properties::all_families()) {
    for (std::uint64_t index = 0; index < cases; ++index) {
      compare_judges(properties::drawn_case(family, seed, index), examined, relations,
                     std::string(family.name) + ' ' + std::to_string(index), agreement);
      if ((index + family.name.size()) % 5 != 0) {
        continue;
      }
      const std::string wild = "wild " + std::string(family.name);
      properties::Stream of_wild = properties::case_stream(seed, wild, index);
      compare_judges(wild_case(of_wild), examined, relations, wild + ' ' + std::to_string(index), agreement);
    }
  }
}

/// Of each family: what the environment variable CAROM_EQUALITY_CASES says, or one, for a quick run.
std::uint64_t cases_of_a_family() {
  const char* said = std::getenv("CAROM_EQUALITY_CASES");
  return said == nullptr ? 1 : std::stoull(said);
}

TEST(JudgeEquality, OfBuiltInSubjects) {
  std::vector<Examined> examined;
  for (const Subject& subject : subjects::all_subjects()) {
    if (subject.absent.empty()) {
      examined.emplace_back(subject);
    }
  }
  Agreement agreement;
  compare_on_all(examined, cases_of_a_family(), Relations::judged, agreement);
  EXPECT_EQ(joined(agreement), "");
  EXPECT_GT(agreement.verdicts, 10000U);
}

TEST(JudgeEquality, OfMutants) {
  std::vector<Examined> examined;
  for (const mutants::Mutant& mutant : mutants::all_mutants()) {
    examined.emplace_back(mutants::subject_of(mutant));
  }
  Agreement agreement;
  compare_on_all(examined, 1, Relations::left_out, agreement);
  EXPECT_EQ(joined(agreement), "");
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    const bool is_relation = invariant.asks() || std::holds_alternative<properties::AboutSession>(invariant.about);
    EXPECT_EQ(agreement.invariants.contains(std::string(invariant.name)), !is_relation) << invariant.name;
  }
}

TEST(JudgeEquality, OnNumbersOfFewDigits) {
  std::vector<Examined> examined;
  for (const Model model : models_with_truth) {
    examined.emplace_back(planting_subject(model, Precision::binary64));
  }
  Agreement agreement;
  for (const properties::Family& family : properties::all_families()) {
    for (std::uint64_t index = 0; index < 6; ++index) {
      properties::Stream stream = properties::case_stream(seed, family.name, index);
      const properties::Case drawn = family.generate(stream);
      const properties::Case one = shortened(drawn, stream);
      if (validate(drawn.collision).empty()) {
        EXPECT_TRUE(validate(one.collision).empty()) << family.name << ' ' << index;
      }
      compare_judges(one, examined, Relations::judged, std::string(family.name) + ' ' + std::to_string(index),
                     agreement);
    }
  }
  EXPECT_EQ(joined(agreement), "");
  EXPECT_GT(agreement.verdicts, 1000U);
}

/// Here the bounds are tight: verdicts come out both ways within a factor of two of what is allowed.
TEST(JudgeEquality, AtTheEdgeOfWhatIsAllowed) {
  std::vector<Examined> examined;
  for (const Model model : models_with_truth) {
    for (const Precision precision : {Precision::binary32, Precision::binary64, Precision::extended}) {
      examined.emplace_back(planting_subject(model, precision));
    }
  }
  Agreement agreement;
  compare_on_all(examined, 3, Relations::left_out, agreement);
  compare_on_all(examined, 1, Relations::judged, agreement);
  EXPECT_EQ(joined(agreement), "");
  for (const char* name : {"backward_error", "linear_momentum", "angular_momentum", "restitution", "reflection_plane",
                           "frictionless_direction", "separating_untouched", "swap", "rotation"}) {
    EXPECT_GT(agreement.invariants[name].violated, 0U) << name;
    EXPECT_GT(agreement.invariants[name].holds, 0U) << name;
  }
}

}  // namespace
}  // namespace carom::equality
