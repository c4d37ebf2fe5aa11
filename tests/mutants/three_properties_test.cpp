// SPDX-License-Identifier: BSL-1.0
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/conformance/rapidcheck.hpp>
#include <carom/properties/three_properties.hpp>
#include <carom/properties/trial/trial.hpp>
#include <carom/subjects/catalogue.hpp>

#include "one_property_broken.hpp"
#include "rejection.hpp"

/// Random tests of the three properties: every built-in solver that claims to be right has them, and of the solvers
/// with a planted defect each lacks one.
namespace carom::mutants {
namespace {

using properties::Claim;
using properties::Judgement;
using properties::Property;
using properties::Status;

/// A subject as it is judged on the invariants of one property.
struct Examined {
  Subject subject;
  Claim claim;
  std::shared_ptr<Session> session;
  std::map<std::string_view, int> held = {};  // cases in which an invariant holds
};

Examined examined(const Subject& subject, const Property& property) {
  Claim claim = properties::claim_of(subject, {});
  std::erase_if(claim.invariants, [&](const properties::Invariant* invariant) {
    return std::find(property.invariants.begin(), property.invariants.end(), invariant->name) ==
           property.invariants.end();
  });
  return {subject, std::move(claim), std::make_shared<Session>(subject.open())};
}

/// What is violated, in words; empty where nothing is.
std::string violation(Examined& one, const properties::JudgedCase& judged_case) {
  const auto solve = [&](const Collision& collision) {
    return properties::lift((*one.session)(std::span(&collision, 1)).at(0));
  };
  std::string text;
  for (const auto& [invariant, verdict] : try_case(judged_case, one.claim, solve).verdicts) {
    one.held[invariant->name] += verdict.status == Status::holds ? 1 : 0;
    if (verdict.status == Status::violated) {
      text += one.subject.name + " violates " + std::string(invariant->name) + ": " + verdict.detail + '\n';
    }
  }
  return text;
}

/// Draws so many cases of each family, each put to all subjects; what RapidCheck finds against them, nothing where it
/// finds nothing.
std::optional<std::string> found_against(std::vector<Examined>& subjects, int cases, bool shrinks) {
  for (const properties::Family& family : properties::all_families()) {
    const auto found = properties::counterexample(properties::rapidcheck_parameters(cases, shrinks), [&] {
      const properties::JudgedCase judged_case(*properties::cases_of(family));
      std::string text;
      for (Examined& one : subjects) {
        text += violation(one, judged_case);
      }
      if (!text.empty()) {
        RC_FAIL(text);
      }
    });
    if (found) {
      return "in the family " + std::string(family.name) + ": " + *found;
    }
  }
  return std::nullopt;
}

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

class ThreeProperties : public testing::TestWithParam<Property> {};

/// Each case is put to all of them at once, so that what is exactly known of it is worked out once.
TEST_P(ThreeProperties, HoldOfEveryBuiltInSolver) {
  std::vector<Examined> subjects;
  for (const Subject& subject : subjects::built_in_subjects()) {
    if (subject.expected_to_pass) {
      subjects.push_back(examined(subject, GetParam()));
    }
  }
  for (const Subject& subject : unbroken_subjects()) {
    subjects.push_back(examined(subject, GetParam()));
  }
  const auto found = found_against(subjects, 8, true);
  EXPECT_FALSE(found) << *found;
  for (const Examined& one : subjects) {
    for (const properties::Invariant* invariant : one.claim.invariants) {
      const auto held = one.held.find(invariant->name);
      EXPECT_TRUE(held != one.held.end() && held->second > 50)
          << invariant->name << " of " << one.subject.name << " was hardly judged";
    }
    EXPECT_TRUE(one.subject.shows_collision_matrix || GetParam().name != "positive_definiteness" ||
                one.claim.invariants.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ThreeProperties,
                         testing::ValuesIn(properties::three_properties().begin(),
                                           properties::three_properties().end()),
                         [](const auto& test) { return std::string(test.param.name); });

class OnePropertyBroken : public testing::TestWithParam<BrokenProperty> {};

/// The random test of its property fails for it, and those of the two others pass.
TEST_P(OnePropertyBroken, IsFoundByTheTestOfThatPropertyAlone) {
  for (const Property& property : properties::three_properties()) {
    std::vector<Examined> subjects{examined(GetParam().subject(), property)};
    const auto found = found_against(subjects, 20, false);
    EXPECT_EQ(found.has_value(), property.name == GetParam().property) << property.title << ": " << found.value_or("");
  }
}

/// Of all invariants that the subject claims, these and no others reject it.
TEST_P(OnePropertyBroken, ViolatesTheseInvariantsAlone) {
  constexpr std::uint64_t fixed_seed = 1;
  constexpr std::uint64_t cases_of_each_family = 60;
  const Subject subject = GetParam().subject();
  const Rejecting rejecting =
      rejecting_invariants(std::span(&subject, 1), properties::all_families(), fixed_seed, cases_of_each_family).at(0);
  EXPECT_EQ(joined(rejecting), joined({GetParam().violates.begin(), GetParam().violates.end()}));
}

TEST_P(OnePropertyBroken, ClaimsNoLaw) {
  EXPECT_EQ(GetParam().subject().model, Model::any);
  const Property& property = property_named(GetParam().property);
  for (const std::string_view invariant : GetParam().violates) {
    EXPECT_NE(std::find(property.invariants.begin(), property.invariants.end(), invariant), property.invariants.end())
        << invariant << " does not judge " << property.title;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, OnePropertyBroken,
                         testing::ValuesIn(broken_properties().begin(), broken_properties().end()),
                         [](const auto& test) { return std::string(test.param.name); });

/// What `linear_momentum` sees alone: where P is the world's origin, an impulse that is lost there has no moment about
/// it.
TEST(LinearMomentum, IsViolatedAloneByAnImpulseLostAtTheOrigin) {
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
        EXPECT_EQ(invariant->name, "linear_momentum") << i;
        ++violated;
      }
    }
  }
  EXPECT_GT(violated, 50);
}

/// The defects are in what is planted, not in what it is planted in.
TEST(UnbrokenSolvers, AreRejectedByNothing) {
  for (const Rejecting& rejecting : rejecting_invariants(unbroken_subjects(), properties::all_families(), 1, 60)) {
    EXPECT_EQ(joined(rejecting), "");
  }
}

}  // namespace
}  // namespace carom::mutants
