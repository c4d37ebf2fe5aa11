// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "examination.hpp"

/// Every invariant holds of every solver that claims it, on every family: within 32 ulps in floating point, and with
/// nothing allowed in ℚ, where the same solver text makes each invariant an exact statement.
namespace carom::properties {
namespace {

struct Claimed {
  const Invariant* invariant;
  Examinee examinee;
};

void PrintTo(const Claimed& claimed, std::ostream* out) {
  *out << claimed.invariant->statement << ' ' << claimed.examinee.name;
}

std::string name_of_test(const testing::TestParamInfo<Claimed>& test) {
  return std::string(test.param.invariant->name) + '_' + test.param.examinee.name;
}

std::vector<Claimed> claimed_by(const std::vector<Examinee>& examinees) {
  std::vector<Claimed> claimed;
  for (const Examinee& examinee : examinees) {
    for (const Invariant& invariant : all_invariants()) {
      // About sessions is what tests/properties/gate/memory_test.cpp asks.
      const bool is_of_sessions = std::holds_alternative<AboutSession>(invariant.about);
      const bool shows_what_it_is_of = examinee.shows_matrix || !invariant.is_of_matrix();
      if (invariant.claimed_for(examinee.model) && shows_what_it_is_of && !is_of_sessions) {
        claimed.push_back({&invariant, examinee});
      }
    }
  }
  return claimed;
}

class Holds : public testing::TestWithParam<Claimed> {};

TEST_P(Holds, For) {
  const auto found = find_violation(GetParam().examinee, invariant_holds(*GetParam().invariant), {.cases = 20});
  EXPECT_FALSE(found) << *found;
}

INSTANTIATE_TEST_SUITE_P(Invariants, Holds, testing::ValuesIn(claimed_by(built_in_examinees())), name_of_test);

class HoldsExactly : public testing::TestWithParam<Claimed> {};

TEST_P(HoldsExactly, For) {
  const auto found = find_violation(GetParam().examinee, invariant_holds(*GetParam().invariant), {.cases = 15});
  EXPECT_FALSE(found) << *found;
}

INSTANTIATE_TEST_SUITE_P(Invariants, HoldsExactly, testing::ValuesIn(claimed_by(exact_examinees())), name_of_test);

/// Whether the answer to the question is a violation in some case of a family.
bool violates_somewhere(const Examinee& examinee, const Question& question) {
  constexpr std::uint64_t cases = 15;
  for (const Family& family : all_families()) {
    for (std::uint64_t index = 0; index < cases; ++index) {
      const JudgedCase judged_case(drawn_case(family, 1, index));
      if (question(examinee, judged_case).status == Status::violated) {
        return true;
      }
    }
  }
  return false;
}

/// The tests above, put to subjects that break the invariant.
class NeverHolds : public testing::TestWithParam<Claimed> {};

TEST_P(NeverHolds, ForASubjectThatObeysNoLaw) {
  const auto& [invariant, examinee] = GetParam();
  const bool is_finite = invariant->name == "finite";
  EXPECT_TRUE(
      violates_somewhere(is_finite ? without_numbers(examinee) : erratic(examinee), invariant_holds(*invariant)));
}

/// A subject that returns its input keeps these, so that nothing is tested.
TEST(FindViolation, ReportsThatNothingWasTested) {
  for (const char* name : {"finite", "linear_momentum", "energy"}) {
    const auto found =
        find_violation(idle(built_in_examinees().front()), invariant_holds(*invariant_named(name)), {.cases = 5});
    ASSERT_TRUE(found) << name;
    EXPECT_NE(found->find("nothing was tested"), std::string::npos) << *found;
  }
}

/// An invariant does not hold if no case was drawn for it, though the head-on probe alone would say so.
TEST(Examination, NoticesFamiliesThatDrawNothing) {
  const std::vector<Examinee> examinees = built_in_examinees();
  const Invariant& momentum = *invariant_named("linear_momentum");
  const auto found_in = [&](std::span<const Family> families) {
    return find_violation(examinees.front(), invariant_holds(momentum), {.cases = 5, .families = families});
  };
  EXPECT_EQ(found_in({}), "no case of a family was in the domain");
  EXPECT_EQ(found_in({family_named("invalid"), 1}), "no case of a family was in the domain");
  const auto of_separating = found_in({family_named("separating"), 1});
  ASSERT_TRUE(of_separating);
  EXPECT_NE(of_separating->find("nothing was tested"), std::string::npos) << *of_separating;
  EXPECT_EQ(found_in({family_named("elastic"), 1}), std::nullopt);
}

/// One examinee of each model in each arithmetic that is judged differently.
std::vector<Examinee> one_of_each() {
  std::vector<Examinee> examinees;
  for (const std::vector<Examinee>& all : {built_in_examinees(), exact_examinees()}) {
    for (const Model model : all_models) {
      for (const Examinee& examinee : all) {
        if (examinee.model == model) {
          examinees.push_back(examinee);
          break;
        }
      }
    }
  }
  return examinees;
}

INSTANTIATE_TEST_SUITE_P(Invariants, NeverHolds, testing::ValuesIn(claimed_by(one_of_each())), name_of_test);

}  // namespace
}  // namespace carom::properties
