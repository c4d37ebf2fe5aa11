// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/conformance/rapidcheck.hpp>

/// The tools that the property tests rest on.
namespace carom::properties {
namespace {

TEST(CasesOfAFamily, ShrinkToSmallDyadicNumbers) {
  const auto found = counterexample(rapidcheck_parameters(100), [] {
    const Case one = *cases_of(*family_named("generic"));
    RC_ASSERT(one.collision.a.immovable || one.collision.a.mass < 3);
  });
  ASSERT_TRUE(found);
  // All that is left is what the property asks for: the shortest number from 3 on, and zeros and ones elsewhere.
  EXPECT_NE(found->find("A: mass 4, principal inertia (1, 1, 1), orientation (1, 0, 0, 0), at (0, 0, 0), "
                        "velocity (0, 0, 0), angular velocity (0, 0, 0)"),
            std::string::npos)
      << *found;
}

TEST(CasesOfAFamily, AreTheSameForTheSameSeed) {
  const auto drawn = [] {
    std::vector<std::string> texts;
    check(10, [&] {
      std::ostringstream one;
      showValue(*cases_of(*family_named("generic")), one);
      texts.push_back(one.str());
    });
    return texts;
  };
  const std::vector<std::string> first = drawn();
  EXPECT_EQ(first, drawn());
  EXPECT_NE(first.at(0), first.at(1));
}

TEST(CasesOfAFamily, OfInvalidCollisionsAreNotShrunk) {
  const rc::Shrinkable<Case> invalid = cases_of(*family_named("invalid"))(rc::Random(fixed_seed));
  EXPECT_FALSE(validate(invalid.value().collision).empty());
  EXPECT_FALSE(invalid.shrinks().next());
}

TEST(Counterexample, NamesTheSeed) {
  const auto found = counterexample(rapidcheck_parameters(1), [] { RC_FAIL(); });
  ASSERT_TRUE(found);
  EXPECT_NE(found->find("seed=" + std::to_string(rapidcheck_parameters(1).seed)), std::string::npos);
}

}  // namespace
}  // namespace carom::properties
