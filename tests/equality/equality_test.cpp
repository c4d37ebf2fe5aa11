// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/bounds/stage.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>

#include "agreement.hpp"
#include "hard_to_judge.hpp"
#include "mutants/catalogue.hpp"
#include "support/cases.hpp"
#include "support/changed_subject.hpp"

/// The filters change no verdict of rational arithmetic. The fuzz target `judge` compares other cases and answers.
namespace carom::equality {
namespace {

/// The environment variable CAROM_SEED selects other cases.
std::uint64_t seed() {
  const char* const text = std::getenv("CAROM_SEED");
  return text == nullptr ? 4 : std::stoull(text);
}

std::vector<Examined> planting_in(std::initializer_list<Precision> precisions) {
  std::vector<Examined> examined;
  for (const Law law : laws_with_truth) {
    for (const Precision precision : precisions) {
      examined.emplace_back(planting_subject(law, precision));
    }
  }
  return examined;
}

/// Compares the judges on `cases` cases of each family. After about every fifth case, it compares them on a wild case
/// (hard_to_judge.hpp), too.
void compare_on_families(std::span<Examined> examined, int cases, properties::RelationTurn relations,
                         Agreement& agreement) {
  for (const properties::Family& family : properties::all_families()) {
    for (std::uint64_t index = 0; index < static_cast<std::uint64_t>(cases); ++index) {
      const std::string name(family.name);
      compare_judges(properties::drawn_case(family, seed(), index), examined, relations,
                     name + ' ' + std::to_string(index), agreement);
      if ((index + name.size()) % 5 == 0) {
        const std::string wild = "wild " + name;
        properties::Stream stream = properties::case_stream(seed(), wild, index);
        compare_judges(wild_case(stream), examined, relations, wild + ' ' + std::to_string(index), agreement);
      }
    }
  }
}

/// Rational arithmetic is quick on few digits, and exact coincidences occur.
TEST(FilteredJudge, EqualsTheRationalJudgeOnNumbersOfFewDigits) {
  std::vector<Examined> examined = planting_in({Precision::binary64});
  Agreement agreement;
  for (const properties::Family& family : properties::all_families()) {
    for (std::uint64_t index = 0; index < 6; ++index) {
      properties::Stream stream = properties::case_stream(seed(), family.name, index);
      const properties::Case drawn = family.generate(stream);
      const properties::Case one = shortened(drawn, stream);
      if (validate(drawn.collision).empty()) {
        EXPECT_TRUE(validate(one.collision).empty()) << family.name << ' ' << index;
      }
      compare_judges(one, examined, {}, std::string(family.name) + ' ' + std::to_string(index), agreement);
    }
  }
  EXPECT_EQ(agreement.differences, "");
}

/// Both verdicts, holds and violated, must occur near the limit.
TEST(FilteredJudge, EqualsTheRationalJudgeNearTheLimit) {
  constexpr int full = 4;
  const bool is_sampled = unit::effort(full) < full;
  std::vector<Examined> examined = is_sampled
                                       ? planting_in({Precision::binary64})
                                       : planting_in({Precision::binary32, Precision::binary64, Precision::extended});
  Agreement agreement;
  compare_on_families(examined, is_sampled ? 0 : full, properties::no_relations, agreement);
  compare_on_families(examined, 1, {}, agreement);
  EXPECT_EQ(agreement.differences, "");
  for (const char* name : {"backward_error", "linear_momentum", "angular_momentum", "restitution", "reflection_plane",
                           "frictionless_direction", "separating_untouched", "swap", "rotation"}) {
    EXPECT_GT(agreement.invariants[name].violated, 0U) << name;
    EXPECT_GT(agreement.invariants[name].holds, 0U) << name;
  }
}

TEST(FilteredJudge, EqualsTheRationalJudgeOnBuiltInSubjectsAndMutants) {
  std::vector<Examined> examined;
  for (const Subject& subject : subjects::all_subjects()) {
    if (subject.absent.empty()) {
      examined.emplace_back(subject);
    }
  }
  std::vector<Examined> defective;
  for (const mutants::Mutant& mutant : mutants::all_mutants()) {
    defective.emplace_back(mutants::subject_of(mutant));
  }
  constexpr int full = 8;
  const int cases = unit::effort(full) < full ? 1 : unit::effort(full);  // all subjects together take 0.2 s for a case
  Agreement agreement;
  compare_on_families(examined, cases, {}, agreement);
  compare_on_families(defective, 1, properties::no_relations, agreement);
  EXPECT_EQ(agreement.differences, "");
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    EXPECT_EQ(agreement.invariants.contains(std::string(invariant.name)), !invariant.is_of_session()) << invariant.name;
  }
}

TEST(FilteredJudge, UsesFiltersUnlessTheyAreOff) {
  for (const bool filtered : {true, false}) {
    properties::GateOptions options = unit::gate_options(8);
    options.limits.filtered = filtered;
    const oracles::StageCounts before = oracles::decided_by_stage();
    (void)run_gate({*subjects::subject_named("frictionless-double"), *subjects::subject_named("reflection-float")},
                   options);
    for (const oracles::Stage stage : oracles::all_stages) {
      EXPECT_EQ(oracles::decided_by_stage()[stage] > before[stage], filtered || stage == oracles::Stage::rational)
          << filtered << ' ' << static_cast<int>(stage);
    }
  }
}

}  // namespace
}  // namespace carom::equality
