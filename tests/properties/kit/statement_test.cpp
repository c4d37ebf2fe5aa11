// SPDX-License-Identifier: BSL-1.0
#include <cstdlib>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/conformance.hpp>
#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/properties/kit/subject.hpp>

#include "support/message_of.hpp"

namespace carom::conformance {
namespace {

Subject idle_callable(Law law) {
  return subject("idle", law, [](const Collision& collision) { return unchanged(collision); });
}

Subject idle_subject(Law law) {
  Subject made = idle_callable(law);
  made.deviates.clear();
  made.shows_collision_matrix = true;
  return made;
}

/// The names of the invariants, or of the families.
template <class Part>
std::set<std::string_view> names_of(const std::vector<Statement>& all, Part Statement::*part) {
  std::set<std::string_view> names;
  for (const Statement& statement : all) {
    names.insert((statement.*part)->name);
  }
  return names;
}

std::set<std::string_view> invariants_of(const std::vector<Statement>& all) {
  return names_of(all, &Statement::invariant);
}

std::set<std::string_view> families_of(const std::vector<Statement>& all) { return names_of(all, &Statement::family); }

TEST(Statements, AreEveryInvariantClaimedInEveryFamily) {
  for (const Law law : all_laws) {
    std::set<std::string_view> claimed;
    for (const properties::Invariant& invariant : properties::all_invariants()) {
      if (invariant.claimed_for(law)) {
        claimed.insert(invariant.name);
      }
    }
    const std::vector<Statement> all = statements(idle_subject(law));
    EXPECT_EQ(invariants_of(all), claimed);
    EXPECT_EQ(families_of(all).size(), properties::all_families().size());
    EXPECT_EQ(all.size(), claimed.size() * properties::all_families().size());
    std::set<std::string> names;
    for (const Statement& statement : all) {
      EXPECT_TRUE(names.insert(name_of(statement)).second) << name_of(statement);
    }
  }
}

TEST(Statements, OfACallableLeaveOutTheMatrixAndInvalidCollisions) {
  std::set<std::string_view> rest = invariants_of(statements(idle_subject(Law::frictionless)));
  for (const char* name : {"invalid_refused", "definite", "well_conditioned", "matrix_used"}) {
    EXPECT_EQ(rest.erase(name), 1U) << name;
  }
  const std::vector<Statement> all = statements(idle_callable(Law::frictionless));
  EXPECT_EQ(invariants_of(all), rest);
  EXPECT_FALSE(families_of(all).contains("invalid"));
  EXPECT_EQ(families_of(all).size(), properties::all_families().size() - 1);
}

TEST(Statements, FollowTheOptions) {
  const std::vector<Statement> all = statements(
      idle_callable(Law::frictionless), {.limit_ulps = 64, .families = {"resting", "generic"}, .deviates = {"energy"}});
  EXPECT_EQ(families_of(all), (std::set<std::string_view>{"generic", "resting"}));
  EXPECT_FALSE(invariants_of(all).contains("energy"));
  EXPECT_TRUE(invariants_of(all).contains("restitution"));
  for (const Statement& statement : all) {
    EXPECT_EQ(statement.suite->yardstick.limits().limit_ulps, 64);
    EXPECT_EQ(statement.suite->yardstick.unit_roundoff(), unit_roundoff(Precision::binary64));
  }
}

TEST(Statements, LeaveOutADeviationInItsFamilyAlone) {
  const std::vector<Statement> all = statements(idle_callable(Law::frictionless),
                                                {.families = {"resting", "generic"}, .deviates = {"energy@generic"}});
  const auto is_stated = [&](std::string_view invariant, std::string_view family) {
    return std::any_of(all.begin(), all.end(), [&](const Statement& statement) {
      return statement.invariant->name == invariant && statement.family->name == family;
    });
  };
  EXPECT_FALSE(is_stated("energy", "generic"));
  EXPECT_TRUE(is_stated("energy", "resting"));
  EXPECT_TRUE(is_stated("restitution", "generic"));
  EXPECT_THROW((void)statements(idle_callable(Law::any), {.deviates = {"energy@generics"}}), std::invalid_argument);
}

TEST(Statements, AreJudgedExactlyWhereThatIsAskedFor) {
  const Subject idle = idle_callable(Law::any);
  const auto is_exact = [&](bool option) {
    return !statements(idle, {.exact = option}).at(0).suite->yardstick.filtered();
  };
  EXPECT_FALSE(is_exact(false));
  EXPECT_TRUE(is_exact(true));
  setenv("CAROM_EXACT", "1", 1);
  EXPECT_TRUE(is_exact(false));
  setenv("CAROM_EXACT", "0", 1);
  EXPECT_FALSE(is_exact(true));
  for (const char* text : {"", "2", "yes"}) {
    setenv("CAROM_EXACT", text, 1);
    EXPECT_THROW((void)statements(idle), std::invalid_argument) << text;
  }
  unsetenv("CAROM_EXACT");
}

TEST(Statements, AreOfTheDomainThatIsChosenOrDeclared) {
  const auto within = [](const Subject& subject, const std::string& text) {
    return statements(subject, {.within = text}).at(0).suite->within;
  };
  Subject idle = idle_callable(Law::any);
  EXPECT_EQ(within(idle, ""), properties::Domain());
  EXPECT_EQ(within(idle, "games"), *properties::domain_named("games"));
  EXPECT_EQ(within(idle, R"({"size": [0.1, 10]})"), properties::domain_from("size=0.1:10"));
  idle.domain = "size=0.1:10,restitution=0.5";
  EXPECT_EQ(within(idle, ""), properties::domain_from("size=0.1:10,restitution=0.5"));
  EXPECT_EQ(within(idle, "everything"), properties::Domain());
  // A family without a case in the domain is left out, unless an option names it.
  EXPECT_FALSE(families_of(statements(idle)).contains("elastic"));
  EXPECT_THROW((void)statements(idle, {.families = {"elastic"}}), std::invalid_argument);
}

TEST(Statements, RefuseWrongOptions) {
  const Subject idle = idle_callable(Law::any);
  const auto message = [&](const Options& options) {
    return unit::message_of<std::invalid_argument>([&] { return statements(idle, options); });
  };
  const std::vector<std::pair<Options, const char*>> wrong{
      {{.families = {"generics"}}, "Options::families: there is no family 'generics'"},
      {{.deviates = {"energies"}}, "Options::deviates: there is no invariant \"energies\""},
      {{.within = "game"}, "Options::within: 'game' names no quantity"},
      {{.within = R"({"size": 3})"}, "Options::within: /size: expected two numbers"},
      {{.digits = 0}, "Options: digits: expected an integer from 1 to 18, found 0"},
      {{.limit_ulps = -1}, "Options: limit_ulps: expected a positive number"},
      {{.effects = {{"slopp", 1}}},
       "Options::effects: there is no effect slopp; expected one of restitution_threshold"},
      {{.effects = {{"slop", -1}}}, "Options::effects: slop: expected a positive number"}};
  for (const auto& [options, expected] : wrong) {
    EXPECT_TRUE(message(options).starts_with(expected)) << message(options);
  }
}

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
  const std::set<std::string> of_another = tests_of("ReflectionInFloat/Conformance");
  EXPECT_TRUE(of_another.contains("Holds/reflection_plane_in_generic"));
  EXPECT_FALSE(of_another.contains("Holds/frictionless_direction_in_generic"));
}

Answer answer_of(const Subject& subject, const Collision& collision) {
  Session session = subject.open();
  return session(std::span(&collision, 1)).at(0);
}

/// A ball hits a resting ball along y at 1 m/s.
Collision along_y() {
  Collision collision;
  collision.a.position = {0, 1, 0};
  collision.a.velocity = {0, -1, 0};
  collision.b.position = {0, -1, 0};
  return collision;
}

template <class S>
Outcome<S> of_contact(const impulse::Contact<S>& contact) {
  return impulse::frictionless(contact);
}

Outcome<float> of_collision(const Collision& collision) {
  return impulse::frictionless(impulse::make_contact<float>(collision));
}

TEST(CallableSubject, TakesContactsOfEachScalarAndCollisions) {
  const std::vector<Subject> subjects{
      subject("float", Law::frictionless, of_contact<float>),
      subject("double", Law::frictionless, of_contact<double>),
      subject("long double", Law::frictionless, of_contact<long double>),
      subject("collision", Law::frictionless, of_collision),
      subject<double>("any", Law::frictionless, [](const auto& contact) { return impulse::frictionless(contact); }),
  };
  const std::vector<Precision> precisions{Precision::binary32, Precision::binary64, Precision::extended,
                                          Precision::binary32, Precision::binary64};
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    SCOPED_TRACE(subjects[i].name);
    EXPECT_EQ(subjects[i].precision, precisions[i]);
    EXPECT_EQ(subjects[i].law, Law::frictionless);
    const Answer answer = answer_of(subjects[i], along_y());
    ASSERT_TRUE(std::holds_alternative<ReportedOutcome>(answer));
    EXPECT_EQ(std::get<ReportedOutcome>(answer).b.velocity[1], -1);
  }
}

TEST(CallableSubject, MayShowItsCollisionMatrix) {
  const auto shown = [](const auto& contact) -> SolvedOutcome<float> {
    const auto see = impulse::collision_matrix(contact);
    return {impulse::reflection(contact), see};
  };
  const std::vector<Subject> showing{
      subject("", Law::reflection, [=](const impulse::Contact<float>& contact) { return shown(contact); }),
      subject("", Law::reflection,
              [=](const Collision& collision) { return shown(impulse::make_contact<float>(collision)); })};
  for (const Subject& one : showing) {
    EXPECT_TRUE(one.shows_collision_matrix);
    EXPECT_EQ(one.precision, Precision::binary32);
    const auto outcome = std::get<ReportedOutcome>(answer_of(one, along_y()));
    ASSERT_TRUE(outcome.collision_matrix);
    EXPECT_EQ(outcome.collision_matrix->diagonal(), (Vector3<long double>{4, 2, 4}));
  }
  EXPECT_FALSE(subject("", Law::frictionless, of_contact<float>).shows_collision_matrix);
  EXPECT_FALSE(subject("", Law::frictionless, of_collision).shows_collision_matrix);
}

TEST(CallableSubject, IsJudgedInThePrecisionThatIsGiven) {
  const Subject rounded = subject(
      "", Law::any, [](const Collision& collision) { return unchanged(collision); }, Precision::binary32);
  EXPECT_EQ(rounded.precision, Precision::binary32);
}

TEST(CallableSubject, DoesNotSeeInvalidCollisions) {
  int calls = 0;
  const Subject counting = subject("", Law::any, [&calls](const Collision& collision) {
    ++calls;
    return unchanged(collision);
  });
  Collision invalid;
  invalid.a.mass = -1;
  EXPECT_TRUE(std::holds_alternative<Refused>(answer_of(counting, invalid)));
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(counting.deviates, std::vector<std::string>{"invalid_refused"});
  EXPECT_TRUE(std::holds_alternative<ReportedOutcome>(answer_of(counting, along_y())));
  EXPECT_EQ(calls, 1);
}

TEST(CallableSubject, IsCopiedForEachSession) {
  const Subject counting = subject("", Law::any, [calls = 0](const Collision& collision) mutable {
    Outcome<double> outcome = unchanged(collision);
    outcome.a.velocity[0] = ++calls;
    return outcome;
  });
  for (int session = 0; session < 2; ++session) {
    EXPECT_EQ(std::get<ReportedOutcome>(answer_of(counting, along_y())).a.velocity[0], 1);
  }
}

}  // namespace
}  // namespace carom::conformance
