// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <limits>

#include <gtest/gtest.h>

#include <carom/impulse/batch/contact_batch.hpp>
#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/impulse/numbers/exact_sum.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/rough.hpp>
#include <carom/oracles/bounds/components.hpp>
#include <carom/oracles/bounds/lifted_outcome.hpp>
#include <carom/oracles/laws/branch.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/properties/gate/histogram.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/scene/crossing.hpp>

/// Tests some preconditions of each library. They are in header functions, so this program checks them even if the
/// libraries are compiled without checks.
namespace carom {
namespace {

TEST(PreconditionDeathTest, AContactIsMadeFromAValidCollision) {
  Collision hit;
  hit.a.mass = -2;
  EXPECT_DEATH(static_cast<void>(impulse::make_contact<double>(hit)), "a.mass");
  hit.a.mass = 2;
  hit.normal = {0, 0, 0};
  EXPECT_DEATH(static_cast<void>(impulse::make_contact<float>(hit)), "normal");
}

TEST(PreconditionDeathTest, ASolverTakesContactsOfValidCollisions) {
  Collision hit;
  hit.a.velocity = {0, -1, 0};
  const impulse::Contact<double> valid = impulse::make_contact<double>(hit);
  static_cast<void>(impulse::reflection(valid));
  for (const auto& damage : std::array<void (*)(impulse::Contact<double>&), 6>{
           [](auto& contact) { contact.a.inverse_mass = -1; },
           [](auto& contact) {
             contact.normal = {0, 0, 0};
           },
           [](auto& contact) { contact.normal[0] = std::numeric_limits<double>::quiet_NaN(); },
           [](auto& contact) { contact.restitution = 1.5; },
           [](auto& contact) { contact.friction = -1; },
           [](auto& contact) { contact.tangential_restitution = -2; },
       }) {
    impulse::Contact<double> damaged = valid;
    damage(damaged);
    EXPECT_DEATH(static_cast<void>(impulse::frictionless(damaged)), "is_made_of_valid");
    EXPECT_DEATH(static_cast<void>(impulse::reflection(damaged)), "is_made_of_valid");
    EXPECT_DEATH(static_cast<void>(impulse::sticking(damaged)), "is_made_of_valid");
    EXPECT_DEATH(static_cast<void>(impulse::rough(damaged)), "is_made_of_valid");
  }
  EXPECT_DEATH(static_cast<void>(impulse::coulomb_impulse(valid)), "friction");
}

TEST(PreconditionDeathTest, OfTheSolversNumbers) {
  const impulse::ContactBatch<double> batch(2);
  EXPECT_DEATH(static_cast<void>(batch.at(2)), "i, size\\(\\): 2 2");
  impulse::ExactSum sum;
  EXPECT_DEATH(sum.add(1, std::numeric_limits<double>::infinity()), "isfinite");
  EXPECT_DEATH(static_cast<void>(impulse::DoubleDouble::of_parts(1, 1)), "high, low: 1 1");
  EXPECT_DEATH(static_cast<void>(impulse::Ldlt::solve<double>(Matrix3<double>::Identity(), {1, 2, 3}, 0)), "least");
}

TEST(PreconditionDeathTest, OfTheOracles) {
  Collision hit;
  hit.b.immovable = true;
  const Outcome<double> after = unchanged(hit);
  EXPECT_DEATH(static_cast<void>(oracles::equation::LinearMomentum{}(hit, after)), "immovable");
  EXPECT_DEATH(static_cast<void>(oracles::equation::AngularMomentum{false}(hit, after)), "immovable");
  EXPECT_DEATH(static_cast<void>(oracles::other_side(oracles::Branch::only)), "only");
  oracles::Components<int> full;
  for (std::size_t i = 0; i < oracles::Components<int>::capacity; ++i) {
    full.push_back(0);
  }
  EXPECT_DEATH(full.push_back(0), "size_: 6");
}

TEST(PreconditionDeathTest, OfTheProperties) {
  using Digits = properties::Histogram<properties::DigitsScale>;
  EXPECT_DEATH(static_cast<void>(Digits().at(0)), "rank, size_: 0 0");
  EXPECT_DEATH(static_cast<void>(Digits::restored({1}, 3, 2)), "smallest, largest: 3 2");
  properties::Case invalid{};
  invalid.collision.a.mass = 0;
  EXPECT_DEATH(static_cast<void>(properties::JudgedCase(invalid).exact()), "is_valid");
}

TEST(PreconditionDeathTest, OfScenes) {
  scene::UncertainQuadratic overlapping{};
  overlapping.c0 = -1;
  EXPECT_DEATH(static_cast<void>(scene::first_crossing(overlapping)), "q.c0, q.e0: -1 0");
}

}  // namespace
}  // namespace carom
