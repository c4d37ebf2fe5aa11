// SPDX-License-Identifier: BSL-1.0
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <carom/conformance.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>

namespace carom::conformance {
namespace {

const Options few{.families = {"generic", "near_head_on", "resting"},
                  .deviates = {"immovable_untouched", "collinear_spin"}};

CAROM_CONFORMANCE(Frictionless, subject("frictionless", Law::frictionless, impulse::frictionless<double>), few);

CAROM_CONFORMANCE(ReflectionInFloat,
                  subject<float>("reflection", Law::reflection,
                                 [](const auto& contact) { return impulse::reflection<impulse::Ldlt>(contact); }),
                  few);

std::set<std::string> tests_of(const std::string& suite_name) {
  std::set<std::string> names;
  const testing::UnitTest& program = *testing::UnitTest::GetInstance();
  for (int s = 0; s < program.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *program.GetTestSuite(s);
    for (int t = 0; suite.name() == suite_name && t < suite.total_test_count(); ++t) {
      names.insert(suite.GetTestInfo(t)->name());
    }
  }
  return names;
}

TEST(Suites, NameATestForEachInvariantAndFamily) {
  const std::set<std::string> tests = tests_of("Frictionless/Conformance");
  EXPECT_TRUE(tests.contains("Holds/restitution_in_near_head_on"));
  EXPECT_TRUE(tests.contains("Holds/frictionless_direction_in_generic"));
  EXPECT_FALSE(tests.contains("Holds/reflection_plane_in_generic"));
  EXPECT_TRUE(tests.contains("JudgesEachInvariant"));
  EXPECT_EQ(tests.size(), 1 + statements(subject("", Law::frictionless, impulse::frictionless<double>), few).size());
}

TEST(Suites, OfTwoSubjectsHaveTheirOwnTests) {
  const std::set<std::string> tests = tests_of("ReflectionInFloat/Conformance");
  EXPECT_TRUE(tests.contains("Holds/reflection_plane_in_generic"));
  EXPECT_FALSE(tests.contains("Holds/frictionless_direction_in_generic"));
}

}  // namespace
}  // namespace carom::conformance
