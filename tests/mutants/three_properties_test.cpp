// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <carom/properties/gate/trial.hpp>
#include <carom/properties/three_properties.hpp>
#include <carom/subjects/catalogue.hpp>

#include "one_property_broken.hpp"
#include "rejection.hpp"

namespace carom::mutants {
namespace {

using properties::Claim;
using properties::Judgement;
using properties::Property;
using properties::Status;

std::string joined(const Rejecting& names) {
  std::string text;
  for (const std::string_view name : names) {
    text.append(text.empty() ? "" : " ").append(name);
  }
  return text;
}

const Property& property_named(std::string_view name) {
  const auto all = properties::three_properties();
  return *std::find_if(all.begin(), all.end(), [&](const Property& one) { return one.name == name; });
}

class OnePropertyBroken : public testing::TestWithParam<BrokenProperty> {};

TEST_P(OnePropertyBroken, ViolatesTheseInvariantsAlone) {
  constexpr std::uint64_t fixed_seed = 1;
  constexpr std::uint64_t cases_of_each_family = 60;
  const Subject subject = GetParam().subject();
  const Rejecting rejecting =
      rejecting_invariants(std::span(&subject, 1), properties::all_families(), fixed_seed, cases_of_each_family).at(0);
  EXPECT_EQ(joined(rejecting), joined({GetParam().violates.begin(), GetParam().violates.end()}));
}

TEST_P(OnePropertyBroken, ClaimsNoLaw) {
  EXPECT_EQ(GetParam().subject().law, Law::any);
  const Property& property = property_named(GetParam().property);
  for (const std::string_view invariant : GetParam().violates) {
    if (invariant == "parting_speed" || invariant == "impulse_bound") {
      continue;  // they bound each outcome, and judge no property
    }
    EXPECT_NE(std::find(property.invariants.begin(), property.invariants.end(), invariant), property.invariants.end())
        << invariant << " does not judge " << property.title;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, OnePropertyBroken,
                         testing::ValuesIn(broken_properties().begin(), broken_properties().end()),
                         [](const auto& test) { return std::string(test.param.name); });

/// If the contact point is the world's origin, a lost impulse has no moment about the origin.
TEST(LinearMomentum, IsViolatedWithoutAngularMomentumByAnImpulseLostAtTheOrigin) {
  const auto all = broken_properties();
  const auto defect =
      std::find_if(all.begin(), all.end(), [](const BrokenProperty& one) { return one.name == "heavier_gets_less"; });
  ASSERT_NE(defect, all.end());
  const Subject subject = defect->subject();
  const Claim claim = properties::claim_of(subject, {});
  Session session = subject.open();
  const auto solve = [&](const Collision& collision) {
    return properties::lift(session(std::span(&collision, 1)).at(0));
  };
  int violated = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    properties::Case one = properties::drawn_case(*properties::family_named("generic"), 1, i);
    one.collision.a.position -= one.collision.point;
    one.collision.b.position -= one.collision.point;
    one.collision.point.setZero();
    const Judgement judgement = try_case(properties::JudgedCase(one), claim, solve);
    for (const auto& [invariant, verdict] : judgement.verdicts) {
      if (verdict.status == Status::violated) {
        EXPECT_TRUE(invariant->name == "linear_momentum" || invariant->name == "impulse_bound")
            << invariant->name << ' ' << i;
        violated += invariant->name == "linear_momentum" ? 1 : 0;
      }
    }
  }
  EXPECT_GT(violated, 50);
}

TEST(UnbrokenSolvers, AreRejectedByNothing) {
  for (const Rejecting& rejecting : rejecting_invariants(unbroken_subjects(), properties::all_families(), 1, 60)) {
    EXPECT_EQ(joined(rejecting), "");
  }
}

}  // namespace
}  // namespace carom::mutants
