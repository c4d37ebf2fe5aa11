// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <gtest/gtest.h>

#include <carom/properties/plan/lint.hpp>

#include "support/cases.hpp"

/// Each lint has a case that triggers it, and a similar case that does not.
namespace carom::properties::plan {
namespace {

/// The findings, each as "severity lint field".
std::vector<std::string> found(const Collision& collision) {
  std::vector<std::string> all;
  for (const LintFinding& finding : findings_of({"", collision, "here:1"})) {
    EXPECT_EQ(finding.place, "here:1");
    EXPECT_FALSE(finding.text.empty());
    all.push_back(std::string(name_of(finding.severity)) + ' ' + std::string(name_of(finding.lint)) + ' ' +
                  finding.field);
  }
  return all;
}

using Found = std::vector<std::string>;

/// A cube of edge 1 and mass 1 hits an immovable body with a corner. The eigenvalues of K are 1 to 5.5.
Collision cube() {
  Collision c;
  c.a.principal_inertia.setConstant(1.0 / 6);
  c.a.position = {0.5, 0.5, 0.5};
  c.a.velocity = {0, -1, 0};
  c.b.immovable = true;
  c.restitution = 0.5;
  return c;
}

TEST(Lint, IsSilentOfACube) { EXPECT_EQ(found(cube()), Found{}); }

/// Ignores lints of mass ratios. Ignores lints of centres of mass, because normals of `physical` fit no surface of the
/// bodies.
TEST(Lint, IsSilentOfConvexUniformBodies) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    Collision c = unit::case_of("physical", i).collision;
    c.normal.normalize();
    c.friction = 0;
    for (Body* body : {&c.a, &c.b}) {
      body->orientation.normalize();
    }
    for (const std::string& finding : found(c)) {
      const bool is_of_normal = finding.find("centre_of_mass") != std::string::npos;
      EXPECT_TRUE(is_of_normal || finding.find("mass_ratio") != std::string::npos) << finding;
    }
  }
}

/// One movable body of mass 1 has the moment I about both axes orthogonal to r. So the largest eigenvalue of K is 1 +
/// ‖r‖²/I.
TEST(Lint, FindsAConditionAbove16) {
  Collision c = cube();
  c.a.position = {1, 0, 0};
  c.a.principal_inertia.setConstant(0x1p-4);  // K = diag(1, 17, 17)
  EXPECT_EQ(found(c), Found{"warning condition a"});
  c.a.principal_inertia = {0x1p-4, 1.0 / 15, 1.0 / 15};  // ‖r‖²/I is about 15
  c.a.principal_inertia.tail<2>().setConstant(0.06667);  // 1/0.06667 < 15
  EXPECT_EQ(found(c), Found{});
  c.a.principal_inertia.tail<2>().setConstant(0.06666);
  EXPECT_EQ(found(c), Found{"warning condition a"});
}

/// B is a hundred times lighter than A. So λ = 1/m_A + 1/m_B is large, and the eigenvalues of K stay below 16 λ.
TEST(Lint, FindsALeverArmOfOneBodyWhereKHidesIt) {
  Collision c = cube();
  c.a.position = {1, 0, 0};
  c.a.principal_inertia.setConstant(0x1p-4);
  c.b.immovable = false;
  c.b.mass = 0.01;
  EXPECT_EQ(found(c), Found{"warning lever_arm a"});
  c.a.principal_inertia.setConstant(0.07);
  EXPECT_EQ(found(c), Found{});
}

TEST(Lint, FindsMomentsThatNoBodyHas) {
  Collision c = cube();
  c.a.principal_inertia = {1, 2, 3.1};
  EXPECT_EQ(found(c), Found{"warning moments a.principal_inertia[2]"});
  c.a.principal_inertia = {1, 2, 3};
  EXPECT_EQ(found(c), Found{}) << "a plate";
  c.a.principal_inertia = {1, 2, std::nextafter(3.0, 4.0)};
  EXPECT_EQ(found(c), Found{}) << "a plate, rounded";
  c.a.principal_inertia = {1, 3 + 1e-7, 2};
  EXPECT_EQ(found(c), Found{"note moments a.principal_inertia[1]"}) << "a plate, rounded in binary32";
}

/// Balls of radius 1/2 touch at the origin, with A above B.
Collision two_balls() {
  Collision c;
  c.a.principal_inertia.setConstant(0.1);
  c.b.principal_inertia.setConstant(0.1);
  c.a.position = {0, 0.5, 0};
  c.b.position = {0, -0.5, 0};
  return c;
}

TEST(Lint, FindsACentreOfMassOnTheOtherSideOfTheContact) {
  Collision c = two_balls();
  EXPECT_EQ(found(c), Found{});
  c.normal = {0, -1, 0};
  EXPECT_EQ(found(c), (Found{"warning centre_of_mass a.position", "warning centre_of_mass b.position"}));
  c = two_balls();
  c.normal = {0, 0x1p-30, 0};
  c.b.position[1] = 0x1p-60;
  c.b.position[0] = 0.5;
  EXPECT_EQ(found(c), (Found{"warning normal_length normal", "warning centre_of_mass b.position"})) << "however little";
}

/// A plate without thickness is hit on its face, so N·(X − P) = 0.
TEST(Lint, IsSilentOfACentreOfMassInThePlaneOfTheContact) {
  Collision c = two_balls();
  c.a.position = {0.25, 0, 0.125};
  c.b.position = {0, 0, 0};
  EXPECT_EQ(found(c), Found{});
  c.normal = {3, 1, 0};  // 3 × 0.1 exceeds 0.3 in binary64, but not the number after 0.3
  c.normal.normalize();
  c.b.position = {0, -0.5, 0};
  c.a.position = {0.1, std::nextafter(-0.3, -1.0), 0};
  EXPECT_EQ(found(c), Found{"note centre_of_mass a.position"}) << "by a rounding error";
}

TEST(Lint, AsksNoImmovableBodyForACentreOfMass) {
  Collision c = two_balls();
  c.b.immovable = true;
  c.b.position = {0, 7, 0};
  EXPECT_EQ(found(c), Found{});
  c.a.position = {0, -0.5, 0};
  EXPECT_EQ(found(c), Found{"warning centre_of_mass a.position"});
}

TEST(Lint, FindsLengthsFarFromOne) {
  Collision c = cube();
  c.normal = {0, 1.1, 0};
  EXPECT_EQ(found(c), Found{"warning normal_length normal"});
  c.normal = {0, 1 + 1e-5, 0};
  EXPECT_EQ(found(c), Found{"note normal_length normal"});
  c.normal = {0, 1 + 1e-7, 0};
  EXPECT_EQ(found(c), Found{});
  c.a.orientation = {0.9, 0, 0, 0};
  EXPECT_EQ(found(c), Found{"warning quaternion_length a.orientation"});
  c.a.orientation = {0.6, 0, 0.8, 0};
  EXPECT_EQ(found(c), Found{});
  c.b.orientation = {2, 0, 0, 0};
  EXPECT_EQ(found(c), Found{}) << "an immovable body has none";
}

TEST(Lint, SaysWhichLengthIsFarFromOne) {
  Collision c = cube();
  c.normal = {0, 1.1, 0};
  c.a.orientation = {0.9, 0, 0, 0};
  const std::vector<LintFinding> findings = findings_of({"", c, "here:1"});
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_TRUE(findings[0].text.starts_with("the normal has length 1.1;")) << findings[0].text;
  EXPECT_TRUE(findings[1].text.starts_with("the quaternion has length 0.9;")) << findings[1].text;
}

TEST(Lint, FindsCoefficientsOutOfRange) {
  Collision c = cube();
  c.restitution = 1.5;
  c.friction = -0.5;
  EXPECT_EQ(found(c), (Found{"warning coefficient restitution", "warning coefficient friction"}));
  c.restitution = 1;
  c.friction = 6;
  EXPECT_EQ(found(c), Found{"note coefficient friction"});
  c.friction = 1;
  c.tangential_restitution = -2;
  EXPECT_EQ(found(c), Found{"warning coefficient tangential_restitution"});
  c.tangential_restitution = -1;
  EXPECT_EQ(found(c), Found{});
}

TEST(Lint, KnowsWhatIsOutOfRangeAndNothingElse) {
  Collision c = cube();
  EXPECT_FALSE(is_out_of_range(c));
  c.restitution = 1.5;
  EXPECT_TRUE(is_out_of_range(c));
  c.a.mass = -1;
  EXPECT_FALSE(is_out_of_range(c)) << "more is wrong with it";
  c.a.mass = 1;
  c.restitution = NAN;
  EXPECT_FALSE(is_out_of_range(c));
}

TEST(Lint, FindsMassRatios) {
  Collision c = cube();
  c.b.immovable = false;
  c.b.position = {0, -0.5, 0};
  c.b.mass = 1e3;
  c.b.principal_inertia.setConstant(1e3);
  EXPECT_EQ(found(c), Found{});
  c.b.mass = 1001;
  EXPECT_EQ(found(c), Found{"note mass_ratio b.mass"});
  c.b.mass = 2e6;
  c.b.principal_inertia.setConstant(2e6);
  EXPECT_EQ(found(c), Found{"warning mass_ratio b.mass"});
  c.b.immovable = true;
  EXPECT_EQ(found(c), Found{});
}

}  // namespace
}  // namespace carom::properties::plan
