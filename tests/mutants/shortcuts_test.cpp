// SPDX-License-Identifier: BSL-1.0
#include "shortcuts.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/features/feature.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/trial.hpp>

namespace carom::mutants {
namespace {

constexpr std::uint64_t seed_of_thresholds = 1;

const Shortcut& shortcut_named(std::string_view name) {
  return *std::ranges::find(all_shortcuts(), name, &Shortcut::name);
}

/// Two of the forty shortcuts may be missed, because a threshold below about 10⁻¹² is within the permitted rounding.
class Shortcuts : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Shortcuts, AreRejectedInTenCasesEach) {
  constexpr std::uint64_t wanted = 10;
  const std::vector<double> thresholds = drawn_thresholds(seed_of_thresholds);
  constexpr std::size_t most_missed = 2;
  const std::vector<std::uint64_t> rejecting = rejecting_cases(thresholds, GetParam(), wanted, most_missed);
  std::string missed;
  std::size_t found = 0;
  for (std::size_t i = 0; i < rejecting.size(); ++i) {
    if (rejecting[i] >= wanted) {
      ++found;
    } else {
      missed += std::string(all_shortcuts()[i].name) + " at " + std::to_string(thresholds[i]) + ": " +
                std::to_string(rejecting[i]) + " cases\n";
    }
  }
  EXPECT_GE(found, all_shortcuts().size() - most_missed) << missed;
}

INSTANTIATE_TEST_SUITE_P(Seeds, Shortcuts, testing::Values(1, 2, 3));

TEST(Shortcut, IsSoundWithoutAThreshold) {
  const std::vector<double> none(all_shortcuts().size(), 0);
  const std::vector<std::uint64_t> rejecting = rejecting_cases(none, 1, 1);
  for (std::size_t i = 0; i < rejecting.size(); ++i) {
    EXPECT_EQ(rejecting[i], 0U) << all_shortcuts()[i].name;
  }
}

TEST(Shortcut, HasANearFeature) {
  for (const Shortcut& shortcut : all_shortcuts()) {
    const std::string name = "near_" + std::string(shortcut.name);
    EXPECT_TRUE(properties::feature_named(name) != nullptr || properties::feature_named("a." + name) != nullptr)
        << name;
  }
}

/// A collision of bodies without symmetry that slip.
Collision general() {
  Collision c;
  c.a.mass = 2;
  c.a.principal_inertia = {0.5, 0.75, 1};
  c.a.orientation = {0.5, 0.5, -0.5, 0.5};
  c.a.position = {0.25, 0.5, -0.125};
  c.a.velocity = {1, -2, 0.5};
  c.a.angular_velocity = {0.5, 1, -1};
  c.b.principal_inertia = {0.25, 0.5, 0.375};
  c.b.position = {-0.25, -0.5, 0.375};
  c.restitution = 0.5;
  return c;
}

bool is_rejected(const Shortcut& shortcut, double threshold, const Collision& collision) {
  const Subject subject = subject_of(shortcut, threshold);
  Session session = subject.open();
  const auto solve = [&](const Collision& c) { return properties::lift(session(std::span(&c, 1)).at(0)); };
  const properties::Judgement judgement =
      properties::try_case(properties::JudgedCase({collision}), properties::claim_of(subject, {}), solve);
  return std::ranges::any_of(judgement.verdicts, [](const properties::NamedVerdict& named) {
    return named.verdict.status == properties::Status::violated;
  });
}

/// The shortcut is wrong just inside its threshold, and right beyond it.
void expect_rejected(std::string_view name, double threshold, const Collision& inside, const Collision& beyond) {
  EXPECT_TRUE(is_rejected(shortcut_named(name), threshold, inside)) << name;
  EXPECT_FALSE(is_rejected(shortcut_named(name), threshold, beyond)) << name;
}

TEST(Shortcut, OfTheLengthOfAQuaternionIsRejected) {
  Collision inside = general();
  Collision beyond = inside;
  inside.a.orientation *= 1 + 1e-7;
  beyond.a.orientation *= 1 + 1e-5;
  expect_rejected("orientation_unit", 1e-6, inside, beyond);
}

TEST(Shortcut, OfMomentsThatAgreeIsRejected) {
  Collision inside = general();
  Collision beyond = inside;
  inside.a.principal_inertia = {0.5, 0.5 + 1e-7, 0.5 - 1e-7};
  beyond.a.principal_inertia = {0.5, 0.5 + 1e-5, 0.5 - 1e-5};
  expect_rejected("moments_equal", 1e-6, inside, beyond);
}

TEST(Shortcut, OfRestitutionIsRejected) {
  Collision inside = general();
  Collision beyond = inside;
  inside.restitution = 1 - 1e-10;
  beyond.restitution = 1 - 1e-8;
  expect_rejected("restitution_one", 1e-9, inside, beyond);
  inside.restitution = 1e-10;
  beyond.restitution = 1e-8;
  expect_rejected("restitution_zero", 1e-9, inside, beyond);
}

/// The diagnosis names the special value, and a distance near the threshold.
TEST(Shortcut, IsDiagnosedWithItsDistance) {
  constexpr double threshold = 1e-6;
  struct Expected {
    std::string_view shortcut;
    std::string_view special;
  };
  const std::array expected{Expected{"moments_equal", "the three moments are equal"},
                            Expected{"masses_equal", "both masses are equal"},
                            Expected{"lever_arm_along_normal", "the lever arm lies along the normal"}};
  properties::GateOptions options;
  options.shrinks = false;
  options.families = {properties::family_named("near_special"), properties::family_named("generic")};
  std::vector<Subject> subjects;
  for (const Expected& one : expected) {
    subjects.push_back(subject_of(shortcut_named(one.shortcut), threshold));
  }
  const std::vector<properties::diagnosis::Diagnosis> found =
      properties::diagnosis::diagnose_all(properties::run_gate(subjects, options));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_FALSE(found[i].faults.empty()) << expected[i].shortcut;
    const std::string& where = found[i].faults[0].where;
    const std::string said = "it nearly holds, within ";
    const std::size_t place = where.find(said);
    ASSERT_NE(place, std::string::npos) << expected[i].shortcut << ": " << where;
    EXPECT_NE(where.find(", that " + std::string(expected[i].special), place), std::string::npos) << where;
    const double distance = std::stod(where.substr(place + said.size()));
    EXPECT_LE(distance, 1.01 * threshold) << where;
    EXPECT_GE(distance, threshold / 10) << where;
  }
  EXPECT_EQ(found[0].faults[0].look_at.find("a tolerance within which"), 0U) << found[0].faults[0].look_at;
}

}  // namespace
}  // namespace carom::mutants
