// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/oracles/laws/judge_error.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/properties/kit/finding.hpp>
#include <carom/properties/three_properties.hpp>
#include <carom/rapidcheck.hpp>
#include <carom/subjects/catalogue.hpp>

#include "mutants/catalogue.hpp"
#include "support/expect_in.hpp"
#include "support/message_of.hpp"
#include "support/planted_formula.hpp"

/// Every sound built-in solver has the three properties. Each solver with a planted defect lacks exactly one.
namespace carom {
namespace {

using properties::Ruling;

Ruling ruling_on(std::string_view property, const ReportedOutcome& answer, const Collision& collision,
                 Precision precision) {
  const auto solver = [&](const Collision&) { return answer; };
  const properties::PropertyOptions options{.precision = precision};
  if (property == "non_penetrating_post_velocity") {
    return properties::non_penetrating_post_velocity(solver, collision, options);
  }
  return property == "positive_definiteness" ? properties::positive_definiteness(solver, collision, options)
                                             : properties::momentum_conservation(solver, collision, options);
}

struct Solver {
  Subject subject;
  Session session;
  std::map<std::string_view, int> in_domain = {};

  explicit Solver(const Subject& of) : subject(of), session(of.open()) {}

  /// The violation in words. Empty if there is none, or if the subject skips the case.
  [[nodiscard]] std::string violation(std::string_view property, const Collision& collision) {
    if (property == "positive_definiteness" && !subject.shows_collision_matrix) {
      return {};
    }
    const Answer answer = session(std::span(&collision, 1)).at(0);
    if (std::holds_alternative<Skipped>(answer)) {
      return {};
    }
    const auto* const outcome = std::get_if<ReportedOutcome>(&answer);
    if (outcome == nullptr) {
      return subject.name + " refuses a valid collision";
    }
    const Ruling ruling = ruling_on(property, *outcome, collision, subject.precision);
    in_domain[property] += ruling.is_in_domain ? 1 : 0;
    return ruling ? std::string() : subject.name + ": " + ruling.text;
  }
};

std::vector<Solver>& every_sound_solver() {
  static std::vector<Solver> all = [] {
    std::vector<Solver> sound;
    for (const Subject& subject : subjects::built_in_subjects()) {
      if (subject.expected_to_pass) {
        sound.emplace_back(subject);
      }
    }
    for (const Subject& subject : mutants::unbroken_subjects()) {
      sound.emplace_back(subject);
    }
    return sound;
  }();
  return all;
}

TEST(EverySolver, HasTheThreePropertiesAndIsJudgedByEach) {
  rc::Random random(1);
  for (Solver& solver : every_sound_solver()) {
    for (int i = 0; i < 100; ++i) {
      const Collision collision = gen::any_family()(random.split(), i).value();
      for (const properties::Property& property : properties::three_properties()) {
        EXPECT_EQ(solver.violation(property.name, collision), "");
      }
    }
    for (const properties::Property& property : properties::three_properties()) {
      if (property.name != "positive_definiteness" || solver.subject.shows_collision_matrix) {
        EXPECT_GT(solver.in_domain[property.name], 10) << solver.subject.name << ' ' << property.name;
      }
    }
  }
}

class PlantedDefect : public testing::TestWithParam<mutants::BrokenProperty> {};

TEST_P(PlantedDefect, LacksThatPropertyAlone) {
  Solver solver(subject_of(GetParam()));
  for (const properties::Property& property : properties::three_properties()) {
    const bool is_found = conformance::falsified(
        "", [&](const Collision& collision) { RC_ASSERT(solver.violation(property.name, collision) == ""); });
    EXPECT_EQ(is_found, property.name == GetParam().property) << property.title;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, PlantedDefect,
                         testing::ValuesIn(mutants::broken_properties().begin(), mutants::broken_properties().end()),
                         [](const auto& test) { return std::string(test.param.name); });

/// A ball flies against a wall at 1 m/s.
Collision against_wall() {
  Collision collision;
  collision.a.velocity = {0, -1, 0};
  collision.b.immovable = true;
  return collision;
}

SolvedOutcome<float> with_matrix(const Collision& collision) {
  const auto contact = impulse::make_contact<float>(collision);
  return {impulse::frictionless(contact), impulse::collision_matrix(contact)};
}

Outcome<double> idle(const Collision& collision) { return unchanged(collision); }

Outcome<double> through_float(const Collision& collision) {
  return map_outcome<double>(impulse::frictionless(impulse::make_contact<double>(collision)),
                             [](double x) { return static_cast<double>(static_cast<float>(x)); });
}

/// The text that RapidCheck prints for a ruling.
std::string shown(const Ruling& ruling) {
  std::ostringstream out;
  showValue(ruling, out);
  return out.str();
}

/// The properties accept any callable, and judge its outcome in the precision of the outcome's numbers.
TEST(ThreeProperties, JudgeTheOutcomeOfAnyCallable) {
  const Collision collision = against_wall();
  EXPECT_TRUE(properties::non_penetrating_post_velocity(with_matrix, collision));
  EXPECT_TRUE(properties::positive_definiteness(with_matrix, collision));
  EXPECT_TRUE(properties::momentum_conservation(with_matrix, collision));
  EXPECT_TRUE(properties::momentum_conservation(idle, collision));
  const Ruling ruling = properties::non_penetrating_post_velocity(idle, collision);
  EXPECT_FALSE(ruling);
  unit::expect_in(ruling.text, {"non_penetration is violated", "  answered\n", "N·V⁺ and 0: -1 and 0, apart by 1"});
  const auto no_number = [](const Collision& one) {
    Outcome<double> after = unchanged(one);
    after.a.velocity[2] = std::nan("");
    return after;
  };
  const Ruling of_nan = properties::non_penetrating_post_velocity(no_number, collision);
  EXPECT_FALSE(of_nan);
  unit::expect_in(shown(of_nan), {"the answer contains infinities or NaN", "Look at: divisions by zero"});
  const auto not_copied = [pointer = std::make_unique<int>()](const Collision& one) { return unchanged(one); };
  EXPECT_FALSE(properties::non_penetrating_post_velocity(not_copied, collision));
}

TEST(ThreeProperties, AreJudgedByTheirOptions) {
  Collision collision = against_wall();
  collision.restitution = 0;
  const auto off = [](const Collision& one) {
    auto after = impulse::frictionless(impulse::make_contact<double>(one));
    after.a.angular_velocity[0] += 1e-6;
    after.a.velocity[1] -= 1e-6;
    return after;
  };
  EXPECT_FALSE(properties::non_penetrating_post_velocity(off, collision));
  EXPECT_TRUE(properties::non_penetrating_post_velocity(off, collision, {.digits = 4}));
  EXPECT_TRUE(properties::non_penetrating_post_velocity(off, collision, {.limit_ulps = 1e11}));
  EXPECT_TRUE(properties::non_penetrating_post_velocity(off, collision, {.precision = Precision::binary32}));
  const Ruling outside = properties::non_penetrating_post_velocity(idle, collision, {.within = "speed=2:3"});
  EXPECT_TRUE(outside);
  EXPECT_FALSE(outside.is_in_domain);
  EXPECT_EQ(outside.text, "the collision is outside of the domain, by its speed");
  EXPECT_FALSE(properties::non_penetrating_post_velocity(idle, collision, {.within = "games"}));
  // A slop lets slow contacts through.
  EXPECT_TRUE(properties::non_penetrating_post_velocity(idle, collision, {.effects = {{"slop", 2}}}));
  EXPECT_THROW((void)properties::momentum_conservation(idle, collision, {.effects = {{"max_speed", 2}}}),
               std::invalid_argument);
  EXPECT_THROW((void)properties::momentum_conservation(idle, collision, {.within = "game"}), std::invalid_argument);
}

TEST(PositiveDefiniteness, NeedsTheMatrixOfACollidingContact) {
  const auto without = [](const Collision& one) {
    return SolvedOutcome<double>(impulse::frictionless(impulse::make_contact<double>(one)));
  };
  Collision collision = against_wall();
  const Ruling ruling = properties::positive_definiteness(without, collision);
  EXPECT_FALSE(ruling);
  unit::expect_in(ruling.text, {"the subject shows no C of this contact"});
  collision.a.velocity = {0, 1, 0};
  const Ruling of_separating = properties::positive_definiteness(without, collision);
  EXPECT_TRUE(of_separating);
  EXPECT_FALSE(of_separating.is_in_domain);
}

TEST(Diagnosis, IsOfAPropertyThatFails) {
  const auto lines = [](const Ruling& ruling) {
    const std::string text = ruling.diagnosis();
    return std::count(text.begin(), text.end(), '\n');
  };
  const Collision collision = gen::generic()(rc::Random(3), 100).value();
  const Ruling narrow = properties::momentum_conservation(through_float, collision);
  ASSERT_FALSE(narrow);
  unit::expect_in(shown(narrow), {"answers fits binary32, but it claims binary64", "Look at: the claimed precision"});
  EXPECT_LE(lines(narrow), 10);
  EXPECT_TRUE(properties::momentum_conservation(through_float, collision, {.precision = Precision::binary32}));

  const Ruling unmoved = properties::non_penetrating_post_velocity(idle, against_wall());
  unit::expect_in(shown(unmoved), {"It does not change the velocities of colliding contacts"});
  EXPECT_LE(lines(unmoved), 10);

  const auto skew = [](const Collision& one) {
    SolvedOutcome<float> solved = with_matrix(one);
    (*solved.collision_matrix)(0, 1) += 1;
    (*solved.collision_matrix)(1, 0) -= 1;
    return solved;
  };
  unit::expect_in(shown(properties::positive_definiteness(skew, against_wall())),
                  {"Its outcomes are right. The collision matrix that it shows is not that of the contact"});

  const auto remembering = [count = std::make_shared<int>(0)](const Collision& one) {
    Outcome<double> after = unchanged(one);
    after.a.velocity[0] += ++*count;
    return after;
  };
  unit::expect_in(shown(properties::non_penetrating_post_velocity(remembering, against_wall())),
                  {"It gives another answer if it is asked again"});

  const auto throwing = [count = std::make_shared<int>(0)](const Collision& one) {
    if (++*count > 1) {
      throw std::runtime_error("tired");
    }
    return unchanged(one);
  };
  unit::expect_in(shown(properties::non_penetrating_post_velocity(throwing, against_wall())),
                  {"non_penetration is violated", "No diagnosis: tired"});
}

TEST(ThreeProperties, NameAFaultOfTheJudgeAndBlameNoSolver) {
  const unit::PlantedFormula planted("non_penetration", [](const properties::Evidence&) -> properties::Verdict {
    throw std::logic_error("a wrong formula");
  });
  const auto solver = [](const Collision& one) { return unchanged(one); };
  unit::expect_in(unit::message_of<oracles::JudgeError>(
                      [&] { return properties::non_penetrating_post_velocity(solver, against_wall()); }),
                  {"the judge failed on this collision, and no subject is at fault: a wrong formula",
                   "for `carom replay FILE`: {"});
}

/// A heavy body turns by less than the least normal number of binary32.
TEST(ThreeProperties, PermitUnderflowInBinary32) {
  const auto solved = [](const Collision& one) { return impulse::frictionless(impulse::make_contact<float>(one)); };
  Collision collision = against_wall();
  collision.a.position = {-0x1p-5, 0x1p-7, 0x1.8p-6};
  collision.a.velocity = {0, -0x1.3p-110, 0};
  collision.a.principal_inertia = {0x1.1p25, 0x1.7p25, 0x1.5p25};
  EXPECT_GT(std::abs(solved(collision).a.angular_velocity[2]), 0);
  EXPECT_LT(std::abs(solved(collision).a.angular_velocity[2]), std::numeric_limits<float>::min());
  EXPECT_TRUE(properties::momentum_conservation(solved, collision));
}

}  // namespace
}  // namespace carom
