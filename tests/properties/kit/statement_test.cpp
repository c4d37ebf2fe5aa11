// SPDX-License-Identifier: BSL-1.0
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/conformance.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>

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

std::set<std::string_view> invariants_of(const std::vector<Statement>& all) {
  std::set<std::string_view> names;
  for (const Statement& statement : all) {
    names.insert(statement.invariant->name);
  }
  return names;
}

std::set<std::string_view> families_of(const std::vector<Statement>& all) {
  std::set<std::string_view> names;
  for (const Statement& statement : all) {
    names.insert(statement.family->name);
  }
  return names;
}

class Given {
 public:
  Given(const char* name, const char* text) : name_(name) { setenv(name, text, 1); }
  ~Given() { unsetenv(name_); }
  Given(const Given&) = delete;
  Given& operator=(const Given&) = delete;

 private:
  const char* name_;
};

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
  {
    const Given given("CAROM_EXACT", "1");
    EXPECT_TRUE(is_exact(false));
  }
  {
    const Given given("CAROM_EXACT", "0");
    EXPECT_FALSE(is_exact(true));
  }
  for (const char* text : {"", "2", "yes"}) {
    const Given given("CAROM_EXACT", text);
    EXPECT_THROW((void)statements(idle), std::invalid_argument) << text;
  }
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
  const auto message = [&](const Options& options) -> std::string {
    try {
      (void)statements(idle, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
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

}  // namespace
}  // namespace carom::conformance
