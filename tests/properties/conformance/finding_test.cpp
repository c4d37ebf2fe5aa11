// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/properties/conformance/finding.hpp>
#include <carom/properties/conformance/subject.hpp>

#include "mutants/catalogue.hpp"

/// The kit's tests pass for sound solvers, and fail for each mutant.
namespace carom::conformance {
namespace {

using properties::Status;

Finding find(const Subject& subject, std::string_view invariant, const std::string& family) {
  for (const Statement& statement : statements(subject, {.families = {family}})) {
    if (statement.invariant->name == invariant) {
      return conformance::find(statement);
    }
  }
  throw std::invalid_argument(std::string(invariant) + " is not claimed");
}

Subject frictionless() { return subject("frictionless", Law::frictionless, impulse::frictionless<double>); }

Subject bouncing_twice() {
  return subject("bouncing", Law::frictionless, [](impulse::Contact<double> contact) {
    contact.restitution *= 2;
    return impulse::frictionless(contact);
  });
}

void expect_in(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
  }
}

TEST(Finding, IsASkipWhereNoCaseIsInTheDomain) {
  const Finding finding = find(frictionless(), "restitution", "resting");
  EXPECT_EQ(finding.status, Status::skipped);
  expect_in(finding.text, {"no case of resting is in the domain of restitution (colliding contacts); first case: the "
                           "contact is not colliding"});
}

TEST(Finding, IsASkipOfAnAbsentSubject) {
  Subject absent = frictionless();
  absent.absent = "not installed";
  absent.open = nullptr;
  const Finding finding = find(absent, "finite", "generic");
  EXPECT_EQ(finding.status, Status::skipped);
  expect_in(finding.text, {"not installed"});
}

TEST(Finding, ShowsTheShrunkWitnessInWords) {
  const Finding finding = find(bouncing_twice(), "restitution", "generic");
  EXPECT_EQ(finding.status, Status::violated);
  expect_in(finding.text, {"bouncing violates restitution in generic; shrunk:\n",
                           "  The normal velocity is reversed and multiplied by ε.\n",
                           "    A: mass 1, principal inertia (1, 1, 1), orientation (1, 0, 0, 0), at (0, 0, 0), ",
                           "restitution 1\n", "  answered\n", "  N·V⁺ and −ε N·V⁻: 2 and 1, apart by 1, allowed ",
                           "  for `carom replay FILE`: {\"a\":"});
}

TEST(Finding, IsTheSameAgain) {
  EXPECT_EQ(find(bouncing_twice(), "energy", "elastic").text, find(bouncing_twice(), "energy", "elastic").text);
}

TEST(Finding, NamesWhatASubjectThrew) {
  const Subject throwing = subject("", Law::any, [](const Collision& collision) -> Outcome<double> {
    if (collision.a.mass > 0) {
      throw std::runtime_error("no convergence");
    }
    return unchanged(collision);
  });
  const Finding finding = find(throwing, "push", "generic");
  EXPECT_EQ(finding.status, Status::violated);
  expect_in(finding.text, {"the subject threw: no convergence", "    A: mass 1, "});
}

TEST(Finding, SaysWhereASubjectRemembers) {
  const Subject tiring = subject("", Law::any, [is_tired = false](const Collision& collision) mutable {
    Outcome<double> outcome = unchanged(collision);
    const Vector3<double> v = properties::relative_velocity(collision);
    if (!is_tired && v.dot(collision.normal) > 1) {
      is_tired = true;
      outcome.a.velocity[0] += 1;
      outcome.b.velocity[0] += 1;
    }
    return outcome;
  });
  const Finding finding = find(tiring, "separating_untouched", "separating");
  EXPECT_EQ(finding.status, Status::violated);
  expect_in(finding.text, {"it keeps state from earlier collisions"});
}

class SoundSuite : public testing::TestWithParam<Subject> {};

TEST_P(SoundSuite, HoldsAndTestsEachInvariant) {
  std::set<std::string_view> untested;
  std::set<std::string_view> tested;
  for (const Statement& statement : statements(GetParam())) {
    const Finding finding = conformance::find(statement);
    EXPECT_NE(finding.status, Status::violated) << finding.text;
    (finding.status == Status::holds ? tested : untested).insert(statement.invariant->name);
  }
  for (const std::string_view name : untested) {
    EXPECT_TRUE(tested.contains(name)) << name << " is skipped in every family";
  }
}

INSTANTIATE_TEST_SUITE_P(Of, SoundSuite,
                         testing::Values(frictionless(), subject<double>("reflection", Law::reflection,
                                                                         [](const auto& contact) {
                                                                           return impulse::reflection<impulse::Ldlt>(
                                                                               contact);
                                                                         })),
                         [](const auto& test) { return test.param.name; });

class MutantSuite : public testing::TestWithParam<mutants::Mutant> {};

TEST_P(MutantSuite, FailsInTheTestsOfTheInvariantsThatSpeakOfTheDefect) {
  for (const std::string_view expected : GetParam().rejected_by) {
    bool failed = false;
    for (const Statement& statement : statements(mutants::subject_of(GetParam()))) {
      if (statement.invariant->name == expected && conformance::find(statement).status == Status::violated) {
        failed = true;
        break;
      }
    }
    EXPECT_TRUE(failed) << expected << " does not fail: " << GetParam().sentence;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, MutantSuite,
                         testing::ValuesIn(mutants::all_mutants().begin(), mutants::all_mutants().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace carom::conformance
