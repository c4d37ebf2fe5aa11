// SPDX-License-Identifier: BSL-1.0
#include "planted.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>

#include "on_families.hpp"
#include "support/effort.hpp"
#include "wild.hpp"

/// Repeats subjects_and_mutants_test.cpp with planted outcomes (planted.hpp), which are hard for the filters.
namespace carom::equality {
namespace {

TEST(JudgeEquality, OnNumbersOfFewDigits) {
  std::vector<Examined> examined;
  for (const Law law : laws_with_truth) {
    examined.emplace_back(planting_subject(law, Precision::binary64));
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

/// Both verdicts, holds and violated, must occur near the limit.
TEST(JudgeEquality, AtTheEdgeOfWhatIsAllowed) {
  std::vector<Examined> examined;
  for (const Law law : laws_with_truth) {
    for (const Precision precision : {Precision::binary32, Precision::binary64, Precision::extended}) {
      examined.emplace_back(planting_subject(law, precision));
    }
  }
  Agreement agreement;
  compare_on_families(examined, static_cast<std::uint64_t>(unit::effort(10)), Relations::left_out, agreement);
  compare_on_families(examined, 1, Relations::judged, agreement);
  EXPECT_EQ(joined(agreement), "");
  for (const char* name : {"backward_error", "linear_momentum", "angular_momentum", "restitution", "reflection_plane",
                           "frictionless_direction", "separating_untouched", "swap", "rotation"}) {
    EXPECT_GT(agreement.invariants[name].violated, 0U) << name;
    EXPECT_GT(agreement.invariants[name].holds, 0U) << name;
  }
}

}  // namespace
}  // namespace carom::equality
