// SPDX-License-Identifier: BSL-1.0
#include "formulas/formulas.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/coulomb.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/cases.hpp"

namespace carom::formulas {
namespace {

/// Contacts with friction of real bodies that are not slender. The bodies do not spin, because the formulas omit
/// gyroscopic torque.
std::vector<Collision> contacts(std::uint64_t count) {
  std::vector<Collision> drawn;
  for (std::uint64_t i = 0; drawn.size() < count; ++i) {
    Collision c = unit::case_of("physical", i).collision;
    c.a.angular_velocity.setZero();
    c.b.angular_velocity.setZero();
    c.friction = static_cast<double>(i % 5) / 4;
    const auto contact = impulse::make_contact<double>(c);
    if (impulse::is_colliding(contact, impulse::normal_velocity(contact)) && !impulse::has_slender(contact)) {
      drawn.push_back(c);
    }
  }
  return drawn;
}

void expect_reproduced(const std::string& name) {
  const Subject subject = *subjects::subject_named(name);
  if (!subject.absent.empty()) {
    GTEST_SKIP() << subject.absent;
  }
  const OutcomeOf* const formula = formula_of(name);
  ASSERT_NE(formula, nullptr);
  const std::vector<Collision> collisions = contacts(200);
  const std::vector<Answer> answers = subject.open()(collisions);
  for (std::size_t i = 0; i < collisions.size(); ++i) {
    const Collision& c = collisions[i];
    const auto computed = map_outcome<double>(std::get<ReportedOutcome>(answers[i]),
                                              [](long double x) { return static_cast<double>(x); });
    const Outcome<double> expected = (*formula)(c);
    // Ten iterations visit three rows, with about 30 roundings for each row. The condition number of K is at most 16,
    // and a body's moments differ by a factor of at most 8. So the error is at most 10 · 3 · 30 · 16 · 8 u < 2⁻³⁶ of
    // the speeds, with the unit roundoff u.
    const double scale = c.a.velocity.norm() + c.b.velocity.norm();
    for (const auto part : {&Outcome<double>::a, &Outcome<double>::b}) {
      EXPECT_LE(((computed.*part).velocity - (expected.*part).velocity).norm(), 0x1p-36 * scale)
          << name << ", case " << i;
    }
  }
}

TEST(EngineFormulas, SayWhatBulletDoesAsShipped) { expect_reproduced("bullet-double-coulomb-as-shipped"); }

TEST(EngineFormulas, SayWhatOdeDoes) {
  expect_reproduced("ode-double-coulomb");
  expect_reproduced("ode-double-coulomb-as-shipped");
}

/// For each engine, a contact exists on which the formula and the law differ by more than 1 % of the change of
/// velocity.
TEST(EngineFormulas, AreNotTheLaw) {
  const std::vector<Collision> collisions = contacts(100);
  for (const char* engine : {"bullet-double", "ode-double", "rapier", "jolt", "cannon", "physx", "oimo", "mujoco"}) {
    for (const char* setting : {"-coulomb", "-coulomb-as-shipped"}) {
      const OutcomeOf* const formula = formula_of(std::string(engine) + setting);
      ASSERT_NE(formula, nullptr) << engine << setting;
      const bool is_other = std::any_of(collisions.begin(), collisions.end(), [&](const Collision& c) {
        const Outcome<double> lawful = impulse::coulomb(impulse::make_contact<double>(c));
        const Outcome<double> computed = (*formula)(c);
        const double change = (lawful.a.velocity - c.a.velocity).norm() + (lawful.b.velocity - c.b.velocity).norm();
        return (computed.a.velocity - lawful.a.velocity).norm() > change / 100;
      });
      EXPECT_TRUE(is_other) << engine << setting;
    }
  }
}

}  // namespace
}  // namespace carom::formulas
