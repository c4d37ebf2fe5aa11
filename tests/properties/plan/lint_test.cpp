// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <gtest/gtest.h>

#include <carom/properties/plan/lint.hpp>

#include "support/cases.hpp"

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

/// Ignores lints of mass ratios. Ignores lints of centres of mass, because normals of `physical` fit no surface of the
/// bodies.
TEST(Lint, FindsNothingWrongWithConvexUniformBodies) {
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

/// Balls of radius 1/2 touch at the origin, with A above B.
Collision two_balls() {
  Collision c;
  c.a.principal_inertia.setConstant(0.1);
  c.b.principal_inertia.setConstant(0.1);
  c.a.position = {0, 0.5, 0};
  c.b.position = {0, -0.5, 0};
  return c;
}

/// A has mass 1, and its moments about both axes orthogonal to r = (1, 0, 0) are I. So the largest eigenvalue of K is
/// 1 + 1/I. B is immovable, or a hundred times lighter than A: then λ = 1/m_A + 1/m_B is large.
Collision with_arm(double moment, bool has_light_b = false) {
  Collision c = cube();
  c.a.position = {1, 0, 0};
  c.a.principal_inertia.setConstant(moment);
  c.b.immovable = !has_light_b;
  c.b.mass = 0.01;
  return c;
}

Collision with_moments(const Vector3<double>& moments) {
  Collision c = cube();
  c.a.principal_inertia = moments;
  return c;
}

Collision with_normal(double length) {
  Collision c = cube();
  c.normal = {0, length, 0};
  return c;
}

Collision with_orientations(const Quaternion<double>& of_a, const Quaternion<double>& of_b = {1, 0, 0, 0}) {
  Collision c = cube();
  c.a.orientation = of_a;
  c.b.orientation = of_b;
  return c;
}

Collision with_coefficients(double restitution, double friction, double tangential_restitution) {
  Collision c = cube();
  c.restitution = restitution;
  c.friction = friction;
  c.tangential_restitution = tangential_restitution;
  return c;
}

Collision with_mass_of_b(double mass, bool is_immovable = false) {
  Collision c = cube();
  c.b.immovable = is_immovable;
  c.b.position = {0, -0.5, 0};
  c.b.mass = mass;
  c.b.principal_inertia.setConstant(mass);
  return c;
}

Collision with_places(const Vector3<double>& of_a, const Vector3<double>& of_b, const Vector3<double>& normal,
                      bool is_b_immovable = false) {
  Collision c = two_balls();
  c.a.position = of_a;
  c.b.position = of_b;
  c.normal = normal;
  c.b.immovable = is_b_immovable;
  return c;
}

TEST(Lint, FindsEachMistakeAndNoneBesideItsBorder) {
  struct Linted {
    const char* what;
    Collision collision;
    Found findings;
  };
  const Vector3<double> up{0, 1, 0};
  for (const auto& [what, collision, findings] : std::vector<Linted>{
           {"a cube", cube(), {}},
           {"K = diag(1, 17, 17)", with_arm(0x1p-4), {"warning condition a"}},
           {"1/I < 15", with_arm(0.06667), {}},
           {"1/I > 15", with_arm(0.06666), {"warning condition a"}},
           {"a lever arm of one body where K hides it", with_arm(0x1p-4, true), {"warning lever_arm a"}},
           {"a shorter lever arm", with_arm(0.07, true), {}},
           {"moments of no body", with_moments({1, 2, 3.1}), {"warning moments a.principal_inertia[2]"}},
           {"a plate", with_moments({1, 2, 3}), {}},
           {"a plate, rounded", with_moments({1, 2, std::nextafter(3.0, 4.0)}), {}},
           {"a plate, rounded in binary32", with_moments({1, 3 + 1e-7, 2}), {"note moments a.principal_inertia[1]"}},
           {"two balls", two_balls(), {}},
           {"two balls with the normal reversed",
            with_places({0, 0.5, 0}, {0, -0.5, 0}, -up),
            {"warning centre_of_mass a.position", "warning centre_of_mass b.position"}},
           {"however little B is on the other side",
            with_places({0, 0.5, 0}, {0.5, 0x1p-60, 0}, 0x1p-30 * up),
            {"warning normal_length normal", "warning centre_of_mass b.position"}},
           {"a plate without thickness, hit on its face", with_places({0.25, 0, 0.125}, {0, 0, 0}, up), {}},
           {"A is on the other side by a rounding error, because 3 × 0.1 exceeds 0.3 in binary64",
            with_places({0.1, std::nextafter(-0.3, -1.0), 0}, {0, -0.5, 0}, Vector3<double>(3, 1, 0).normalized()),
            {"note centre_of_mass a.position"}},
           {"an immovable body on the other side", with_places({0, 0.5, 0}, {0, 7, 0}, up, true), {}},
           {"a movable body on the side of the immovable one",
            with_places({0, -0.5, 0}, {0, 7, 0}, up, true),
            {"warning centre_of_mass a.position"}},
           {"a long normal", with_normal(1.1), {"warning normal_length normal"}},
           {"a rounded normal", with_normal(1 + 1e-5), {"note normal_length normal"}},
           {"a normal of length 1, rounded in binary32", with_normal(1 + 1e-7), {}},
           {"a short quaternion", with_orientations({0.9, 0, 0, 0}), {"warning quaternion_length a.orientation"}},
           {"a quaternion of length 1", with_orientations({0.6, 0, 0.8, 0}), {}},
           {"a long quaternion of an immovable body", with_orientations({1, 0, 0, 0}, {2, 0, 0, 0}), {}},
           {"ε > 1 and μ < 0",
            with_coefficients(1.5, -0.5, 0),
            {"warning coefficient restitution", "warning coefficient friction"}},
           {"a large μ", with_coefficients(1, 6, 0), {"note coefficient friction"}},
           {"e_t < −1", with_coefficients(1, 1, -2), {"warning coefficient tangential_restitution"}},
           {"e_t = −1", with_coefficients(1, 1, -1), {}},
           {"masses of 1 : 1000", with_mass_of_b(1e3), {}},
           {"masses of 1 : 1001", with_mass_of_b(1001), {"note mass_ratio b.mass"}},
           {"masses of 1 : 2 million", with_mass_of_b(2e6), {"warning mass_ratio b.mass"}},
           {"a heavy immovable body", with_mass_of_b(2e6, true), {}},
       }) {
    EXPECT_EQ(found(collision), findings) << what;
  }
}

TEST(Lint, StatesTheLengthThatIsFarFromOne) {
  Collision c = cube();
  c.normal = {0, 1.1, 0};
  c.a.orientation = {0.9, 0, 0, 0};
  const std::vector<LintFinding> findings = findings_of({"", c, "here:1"});
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_TRUE(findings[0].text.starts_with("the normal has length 1.1;")) << findings[0].text;
  EXPECT_TRUE(findings[1].text.starts_with("the quaternion has length 0.9;")) << findings[1].text;
}

TEST(Lint, CallsACollisionOutOfRangeOnlyIfNothingElseIsWrongWithIt) {
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

}  // namespace
}  // namespace carom::properties::plan
