// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/where.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/features/quantities.hpp>

#include "support/expect_in.hpp"

namespace carom::properties::diagnosis {
namespace {

struct Sampled {
  GateReport report;
  std::vector<std::vector<std::uint64_t>> violated;

  template <class IsViolated>
  explicit Sampled(IsViolated is_violated) {
    for (const char* name : {"generic", "structured", "mass_ratio", "separating", "immovable_a", "driven_wall"}) {
      const Family* family = family_named(name);
      report.options.families.push_back(family);
      std::vector<SampledCase>& sampled = report.sampled.emplace_back();
      std::vector<std::uint64_t>& numbers = violated.emplace_back();
      for (std::uint64_t number = 0; number < 600; ++number) {
        const Collision collision = drawn_case(*family, 1, number).collision;
        SampledCase& one = sampled.emplace_back();
        if (validate(collision).empty()) {
          one = {true, oracles::ExactCase(collision).state(), feature_places_of(collision), quantities_of(collision),
                 collision};
          if (is_violated(collision, one.approach)) {
            numbers.push_back(number);
          }
        }
      }
    }
  }

  [[nodiscard]] std::string words(const JudgedSample& judged = {600}) const {
    return in_words(where_violated(report, {violated, std::vector<JudgedSample>(6, judged)}));
  }
};

constexpr auto colliding = oracles::ContactState::colliding;

TEST(Where, NoSentenceIsGivenIfNothingIsViolated) {
  EXPECT_EQ(Sampled([](const Collision&, auto) { return false; }).words(), "");
}

TEST(Where, AllCollidingContactsAreNamedByTheirApproach) {
  unit::expect_in(Sampled([](const Collision&, auto approach) { return approach == colliding; }).words(),
                  {"in 100 % of the colliding contacts"});
  unit::expect_in(
      Sampled([](const Collision&, auto approach) { return approach == oracles::ContactState::separating; }).words(),
      {"separating contacts"});
}

/// Half of the cases are skipped, and all others fail.
TEST(Where, AShareIsOfTheJudgedCases) {
  JudgedSample every_second{600};
  for (std::uint64_t number = 0; number < 600; number += 2) {
    every_second.skipped.push_back(number);
  }
  Sampled sampled([](const Collision&, auto approach) { return approach == colliding; });
  for (std::vector<std::uint64_t>& numbers : sampled.violated) {
    std::erase_if(numbers, [](std::uint64_t number) { return number % 2 == 0; });
  }
  unit::expect_in(sampled.words(every_second), {"in 100 % of the colliding contacts"});
  EXPECT_EQ(sampled.words().find("in 100 %"), std::string::npos) << sampled.words();
}

TEST(Where, AFeatureOfEitherBodyIsFound) {
  const std::string words = Sampled([](const Collision& c, auto approach) {
                              return approach == colliding && (c.a.orientation[0] < 0 || c.b.orientation[0] < 0) &&
                                     !c.a.immovable && !c.b.immovable;
                            }).words();
  unit::expect_in(words, {"if for A or B the quaternion's w < 0 (67 % of such colliding contacts fail, else 0 %)"});
}

TEST(Where, ALimitOfTheMassRatioIsFoundOnItsSide) {
  const std::string words = Sampled([](const Collision& c, auto approach) {
                              return approach == colliding && !c.a.immovable && !c.b.immovable &&
                                     (c.a.mass > 100 * c.b.mass || c.b.mass > 100 * c.a.mass);
                            }).words();
  unit::expect_in(words, {"if the larger mass over the smaller is at least 1"});
  unit::expect_in(words, {" (100 % of such colliding contacts fail, else 0 %)"});
}

TEST(Where, AnAbsentFeatureIsFoundAsACondition) {
  const std::string words = Sampled([](const Collision& c, auto approach) {
                              return approach == colliding && !c.a.immovable && !c.b.immovable;
                            }).words();
  unit::expect_in(words, {"unless A or B is immovable (0 % of such colliding contacts fail, else 100 %)"});
}

TEST(Where, NoConditionIsFoundIfEverySeventhCaseFails) {
  int count = 0;
  const std::string words =
      Sampled([&](const Collision&, auto approach) { return approach == colliding && ++count % 7 == 0; }).words();
  EXPECT_TRUE(words.starts_with("in ")) << words;
}

/// Only some of the collisions with w < 0 are violated, so w < 0 does not distinguish the violated collisions.
TEST(Where, AFeatureThatManySoundCasesHaveIsNoFinding) {
  const auto words_if = [](int of_three) {
    int count = 0;
    return Sampled([&](const Collision& c, auto approach) {
             return approach == colliding && !c.a.immovable && !c.b.immovable &&
                    (c.a.orientation[0] < 0 || c.b.orientation[0] < 0) && ++count % 3 < of_three;
           })
        .words();
  };
  EXPECT_EQ(words_if(1).find("the quaternion's w < 0"), std::string::npos) << words_if(1);
  unit::expect_in(words_if(3), {"for A or B the quaternion's w < 0"});
}

TEST(Where, NothingIsSaidOfFewerViolatedCasesThanAHintNeeds) {
  const auto words_of_first = [](std::uint64_t number) {
    std::uint64_t count = 0;
    return Sampled([&](const Collision&, auto approach) { return approach == colliding && ++count <= number; }).words();
  };
  EXPECT_EQ(words_of_first(least_violated - 1), "");
  EXPECT_NE(words_of_first(least_violated), "");
}

/// There are several hundred conditions. So by chance, some of them hold in all of a dozen violated cases.
TEST(Where, AConditionOfADozenCasesByChanceIsNoFinding) {
  for (int offset = 0; offset < 8; ++offset) {
    int count = offset;
    const std::string words =
        Sampled([&](const Collision&, auto approach) { return approach == colliding && ++count % 150 == 0; }).words();
    EXPECT_TRUE(words.starts_with("in ")) << words;
  }
}

}  // namespace
}  // namespace carom::properties::diagnosis
