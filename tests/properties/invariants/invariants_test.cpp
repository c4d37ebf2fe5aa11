// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "examination.hpp"
#include "support/selected.hpp"

/// Every invariant holds on every family for every solver that claims it. The limit is 32 ulps in floating point, and 0
/// in ℚ.
namespace carom::properties {
namespace {

struct Claimed {
  const Invariant* invariant;
  Examinee examinee;
};

void PrintTo(const Claimed& claimed, std::ostream* out) {
  *out << claimed.invariant->statement << ' ' << claimed.examinee.name;
}

std::string name_of(const Claimed& claimed) {
  return std::string(claimed.invariant->name) + '_' + claimed.examinee.name;
}

std::string name_of_test(const testing::TestParamInfo<Claimed>& test) { return name_of(test.param); }

std::vector<Claimed> claimed_by(const std::vector<Examinee>& examinees) {
  std::vector<Claimed> claimed;
  for (const Examinee& examinee : examinees) {
    for (const Invariant& invariant : all_invariants()) {
      // tests/properties/gate/memory_test.cpp tests the invariants about sessions.
      const bool is_of_sessions = std::holds_alternative<AboutSession>(invariant.about);
      const bool shows_what_it_is_of = examinee.shows_matrix || !invariant.is_of_matrix();
      if (invariant.claimed_for(examinee.law) && shows_what_it_is_of && !is_of_sessions) {
        claimed.push_back({&invariant, examinee});
      }
    }
  }
  return claimed;
}

/// The tests of a suite share one pass over the families. The pass judges only the claims whose tests run.
class OnePass : public testing::TestWithParam<Claimed> {
 protected:
  template <class ExamineeOf>
  static void examine_selected(const std::vector<Claimed>& all, std::uint64_t cases, const ExamineeOf& examinee_of) {
    examination = {.cases = cases};
    claimants.clear();
    places.clear();
    for (const Claimed& claimed : all) {
      if (!unit::is_selected(name_of(claimed))) {
        continue;
      }
      const Examinee examinee = examinee_of(claimed);
      const auto known = std::find_if(claimants.begin(), claimants.end(),
                                      [&](const Claimant& one) { return one.examinee.name == examinee.name; });
      places[name_of(claimed)] = static_cast<std::size_t>(known - claimants.begin());
      (known == claimants.end() ? claimants.emplace_back(Claimant{examinee, {}}) : *known)
          .invariants.push_back(claimed.invariant);
    }
    seen = examine(claimants, examination);
  }

  static Examinee itself(const Claimed& claimed) { return claimed.examinee; }

  static void expect_no_violation(const Claimed& claimed) {
    const std::size_t place = places.at(name_of(claimed));
    const auto found = found_by(seen[place], claimants[place], *claimed.invariant, examination);
    EXPECT_FALSE(found) << *found;
  }

  static inline Examination examination;
  static inline std::vector<Claimant> claimants;
  static inline std::map<std::string, std::size_t> places;  // of the claimant, by a test's name
  static inline std::vector<Seen> seen;
};

class Holds : public OnePass {
 protected:
  static void SetUpTestSuite() { examine_selected(claimed_by(built_in_examinees()), 20, itself); }
};

TEST_P(Holds, For) { expect_no_violation(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Invariants, Holds, testing::ValuesIn(claimed_by(built_in_examinees())), name_of_test);

class HoldsExactly : public OnePass {
 protected:
  static void SetUpTestSuite() { examine_selected(claimed_by(exact_examinees()), 15, itself); }
};

TEST_P(HoldsExactly, For) { expect_no_violation(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Invariants, HoldsExactly, testing::ValuesIn(claimed_by(exact_examinees())), name_of_test);

/// For each law, one examinee in floating point, and one in ℚ if any.
std::vector<Examinee> one_of_each() {
  std::vector<Examinee> examinees;
  for (const std::vector<Examinee>& all : {built_in_examinees(), exact_examinees()}) {
    for (const Law law : all_laws) {
      for (const Examinee& examinee : all) {
        if (examinee.law == law) {
          examinees.push_back(examinee);
          break;
        }
      }
    }
  }
  return examinees;
}

class NeverHolds : public OnePass {
 protected:
  static void SetUpTestSuite() {
    examine_selected(claimed_by(one_of_each()), 15, [](const Claimed& claimed) {
      return claimed.invariant->name == "finite" ? without_numbers(claimed.examinee) : erratic(claimed.examinee);
    });
  }
};

TEST_P(NeverHolds, ForASubjectThatObeysNoLaw) {
  EXPECT_TRUE(seen[places.at(name_of(GetParam()))].violated.contains(GetParam().invariant));
}

INSTANTIATE_TEST_SUITE_P(Invariants, NeverHolds, testing::ValuesIn(claimed_by(one_of_each())), name_of_test);

/// These invariants hold if a solver keeps the velocities.
TEST(FindViolation, ReportsThatNothingWasTested) {
  for (const char* name : {"finite", "linear_momentum", "energy"}) {
    const auto found =
        find_violation(idle(built_in_examinees().front()), invariant_holds(*invariant_named(name)), {.cases = 5});
    ASSERT_TRUE(found) << name;
    EXPECT_NE(found->find("nothing was tested"), std::string::npos) << *found;
  }
}

/// If no case tests an invariant, find_violation says so, even if the head-on probe passes.
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

}  // namespace
}  // namespace carom::properties
