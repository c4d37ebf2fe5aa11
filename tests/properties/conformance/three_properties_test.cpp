// SPDX-License-Identifier: BSL-1.0
#include <map>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/properties/conformance/falsified.hpp>
#include <carom/properties/three_properties.hpp>
#include <carom/rapidcheck.hpp>
#include <carom/subjects/catalogue.hpp>

#include "mutants/one_property_broken.hpp"

/// Every sound built-in solver has the three properties. Each solver with a planted defect lacks exactly one.
namespace carom {
namespace {

using properties::Ruling;

using JudgedProperty = Ruling (*)(const ReportedOutcome&, const Collision&, const Precision&);

template <class Judge>
Ruling of_answer(const Judge& judge, const ReportedOutcome& answer, const Collision& collision, Precision precision) {
  return judge([&](const Collision&) { return answer; }, collision, precision);
}

constexpr auto never_penetrates = [](const auto&... all) { return properties::non_penetrating_post_velocity(all...); };
constexpr auto has_definite_matrix = [](const auto&... all) { return properties::positive_definiteness(all...); };
constexpr auto keeps_momentum = [](const auto&... all) { return properties::momentum_conservation(all...); };

const std::map<std::string_view, JudgedProperty>& judged_properties() {
  static const std::map<std::string_view, JudgedProperty> all{
      {"non_penetrating_post_velocity", [](const auto&... of) { return of_answer(never_penetrates, of...); }},
      {"positive_definiteness", [](const auto&... of) { return of_answer(has_definite_matrix, of...); }},
      {"momentum_conservation", [](const auto&... of) { return of_answer(keeps_momentum, of...); }}};
  return all;
}

struct Solver {
  Subject subject;
  Session session;
  std::map<std::string_view, int> in_domain = {};

  explicit Solver(const Subject& of) : subject(of), session(of.open()) {}

  /// The violation in words. Empty if there is none, or if the subject skips the case.
  [[nodiscard]] std::string violation(std::string_view property, const Collision& collision) {
    const Answer answer = session(std::span(&collision, 1)).at(0);
    if (std::holds_alternative<Skipped>(answer)) {
      return {};
    }
    const auto* const outcome = std::get_if<ReportedOutcome>(&answer);
    if (outcome == nullptr) {
      return subject.name + " refuses a valid collision";
    }
    const Ruling ruling = judged_properties().at(property)(*outcome, collision, subject.precision);
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

void expect_of_every_solver(std::string_view property, const Collision& collision) {
  for (Solver& solver : every_sound_solver()) {
    RC_ASSERT(solver.violation(property, collision) == "");
  }
}

RC_GTEST_PROP(EverySolver, NeverPenetrates, (const Collision& collision)) {
  expect_of_every_solver("non_penetrating_post_velocity", collision);
}

RC_GTEST_PROP(EverySolver, HasAPositiveDefiniteMatrix, (const Collision& collision)) {
  expect_of_every_solver("positive_definiteness", collision);
}

RC_GTEST_PROP(EverySolver, ConservesMomentum, (const Collision& collision)) {
  expect_of_every_solver("momentum_conservation", collision);
}

TEST(EverySolver, IsJudged) {
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
  Solver solver(GetParam().subject());
  for (const properties::Property& property : properties::three_properties()) {
    const bool is_found = conformance::falsified(
        "", [&](const Collision& collision) { RC_ASSERT(solver.violation(property.name, collision) == ""); });
    EXPECT_EQ(is_found, property.name == GetParam().property) << property.title;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, PlantedDefect,
                         testing::ValuesIn(mutants::broken_properties().begin(), mutants::broken_properties().end()),
                         [](const auto& test) { return std::string(test.param.name); });

/// The properties accept any callable, and judge its outcome in the precision of the outcome's numbers.
TEST(ThreeProperties, AreOfAnyCallable) {
  Collision collision;
  collision.a.velocity = {0, -1, 0};
  collision.b.immovable = true;
  const auto solved = [](const Collision& one) -> SolvedOutcome<float> {
    const auto contact = impulse::make_contact<float>(one);
    const auto matrix = impulse::collision_matrix(contact);
    return {impulse::frictionless(contact), matrix};
  };
  const auto idle = [](const Collision& one) { return unchanged(one); };
  EXPECT_TRUE(properties::non_penetrating_post_velocity(solved, collision));
  EXPECT_TRUE(properties::positive_definiteness(solved, collision));
  EXPECT_TRUE(properties::momentum_conservation(solved, collision));
  EXPECT_TRUE(properties::momentum_conservation(idle, collision));
  const Ruling ruling = properties::non_penetrating_post_velocity(idle, collision);
  EXPECT_FALSE(ruling);
  EXPECT_NE(ruling.text.find("non_penetration"), std::string::npos) << ruling.text;
  const auto no_number = [](const Collision&) { return Outcome<double>{{{0, 0, std::nan("")}, {}}, {}}; };
  EXPECT_FALSE(properties::non_penetrating_post_velocity(no_number, collision));
}

}  // namespace
}  // namespace carom
