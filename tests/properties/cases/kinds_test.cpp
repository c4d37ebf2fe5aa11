// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/geometry.hpp>
#include <carom/properties/gate/shrink.hpp>
#include <carom/properties/gate/trial.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

constexpr std::uint64_t seed_of_kinds = 3;

/// A solid sphere of radius 1 falls on another of radius 2, in the plane x = 0.
Collision stacked() {
  Collision c;
  c.point = {0, 1, 0};
  c.a.position = {0, 2, 0};
  c.a.principal_inertia.setConstant(0.4);
  c.a.velocity = {0, -1, 2};
  c.a.angular_velocity = {3, 0, 0};
  c.b.position = {0, -1, 0};
  c.b.principal_inertia.setConstant(1.6);
  return c;
}

bool lies_in(const std::string& kind, const Collision& c) { return contains(domain_from(kind), c); }

TEST(Kinds, ContainWhatTheirFormulasSay) {
  const std::vector<std::string> kinds{
      "bodies=spheres", "bodies=solid_spheres", "movable=both", "movable=one", "movable=a",
      "movable=b",      "walls=resting",        "plane=yz"};
  // A change of the stacked spheres, and for each kind whether it then contains them.
  const std::map<std::string, std::string> changes{
      {"{}", "11100011"},
      {R"({"a": {"principal_inertia": [0.6, 0.6, 0.6]}})", "10100011"},  // a shell
      {R"({"b": {"principal_inertia": [1.6, 1.7, 1.6]}})", "00100011"},
      {R"({"a": {"position": [0, 1, 0]}})", "00100011"},  // without a radius
      {R"({"a": {"position": [0, 0, 0]}})", "00100011"},  // hollow
      {R"({"a": {"position": [0, 2, 1e-13]}})", "00100011"},
      {R"({"b": {"immovable": true}})", "11011011"},
      {R"({"a": {"immovable": true, "velocity": [0, 0, 0], "angular_velocity": [0, 0, 0]}})", "11010111"},
      {R"({"b": {"immovable": true, "velocity": [0, 0, 1]}})", "11011001"},
      {R"({"b": {"immovable": true, "angular_velocity": [1, 0, 0]}})", "11011001"},
      {R"({"a": {"immovable": true}, "b": {"immovable": true}})", "11000001"},
      {R"({"point": [1e-300, 1, 0]})", "11100010"},
      {R"({"normal": [1e-300, 1, 0]})", "11100010"},
      {R"({"b": {"position": [1e-300, -1, 0]}})", "11100010"},
      {R"({"b": {"velocity": [1, 0, 0]}})", "11100010"},
      {R"({"b": {"velocity": [-0.0, 0, 0]}})", "11100011"},
      {R"({"a": {"angular_velocity": [0, 1, 0]}})", "11100010"},
      {R"({"a": {"orientation": [1, 2, 0, 0]}})", "11100011"},  // about the normal of the plane
      {R"({"a": {"orientation": [0, 0, 1, 2]}})", "11100011"},  // half a turn, about an axis in the plane
      {R"({"a": {"orientation": [1, 0, 1, 0]}})", "11100010"},
  };
  for (const auto& [change, expected] : changes) {
    nlohmann::json changed = collision_to_json(stacked());
    changed.merge_patch(nlohmann::json::parse(change));
    for (const char* const body : {"a", "b"}) {
      if (changed[body].value("immovable", false)) {
        for (const char* const field : {"mass", "principal_inertia", "orientation"}) {
          changed[body].erase(field);
        }
      }
    }
    std::string found;
    for (const std::string& kind : kinds) {
      found += lies_in(kind, collision_from_json(changed)) ? '1' : '0';
    }
    EXPECT_EQ(found, expected) << change;
  }
}

// The contact is computed from the centre, the radius and a rounded normal of unit length, at any distance from the
// origin.
TEST(Kinds, ContainSpheresInDecimals) {
  int spheres = 0;
  Stream stream = stream_from(1);
  for (int i = 0; i < 1000; ++i) {
    Collision c;
    const double distance = stream.power_of_ten(-3, 9);
    c.a.position = stream.vector() * distance;
    c.b.immovable = true;
    c.normal = stream.direction();
    c.normal /= length(c.normal);
    const double radius = stream.power_of_ten(-2, 2) * (1 + stream.unit());
    c.point = plus(c.a.position, c.normal, -radius);
    if (length(c.point - c.a.position) < radius / 2) {
      continue;  // the radius is within rounding of the position
    }
    ++spheres;
    c.a.mass = 0.1 + stream.unit();
    c.a.principal_inertia.setConstant(2.0 / 5 * c.a.mass * radius * radius);
    EXPECT_TRUE(lies_in("bodies=solid_spheres", c)) << i;
    c.normal = plus(c.normal, orthogonal(c.normal), 1e-3 + 0x1p-48 * distance / radius);
    EXPECT_FALSE(lies_in("bodies=spheres", c)) << i;
  }
  EXPECT_GT(spheres, 900);
}

const std::vector<std::string>& some_kinds() {
  static const std::vector<std::string> texts{
      "bodies=spheres",
      "bodies=solid_spheres",
      "movable=both",
      "movable=one",
      "movable=a",
      "movable=b",
      "walls=resting",
      "plane=xy",
      "plane=yz",
      "plane=zx",
      "bodies=spheres,movable=both",
      "bodies=solid_spheres,movable=a,walls=resting",
      "movable=b,walls=resting,plane=zx",
  };
  return texts;
}

TEST(Kinds, HaveCasesOfEachFamilyThatCanLieThere) {
  const std::set<std::string> walls{"immovable_a", "immovable_b", "driven_wall", "both_immovable"};
  const std::map<std::string, std::set<std::string>> without_case{
      {"bodies=spheres", {"near_collinear", "zero_lever"}},
      {"bodies=solid_spheres", {"near_collinear", "zero_lever"}},
      {"movable=both", walls},
      {"movable=one", {"both_immovable"}},
      {"movable=a", {"immovable_a", "both_immovable"}},
      {"movable=b", {"immovable_b", "both_immovable"}},
      {"walls=resting", {"driven_wall", "both_immovable"}},
      {"plane=xy", {}},
      {"plane=yz", {}},
      {"plane=zx", {}},
      {"bodies=spheres,movable=both",
       {"near_collinear", "zero_lever", "immovable_a", "immovable_b", "driven_wall", "both_immovable"}},
      {"bodies=solid_spheres,movable=a,walls=resting",
       {"near_collinear", "immovable_a", "driven_wall", "both_immovable"}},
  };
  for (const auto& [kind, without] : without_case) {
    for (const Family& family : all_families()) {
      EXPECT_EQ(has_cases_within(domain_from(kind), family, seed_of_kinds),
                without.count(std::string(family.name)) == 0)
          << kind << ' ' << family.name;
    }
  }
}

// A solver reads the motion of invalid collisions, too.
TEST(Kinds, HoldTheValidFieldsOfInvalidCollisions) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    const Collision c =
        drawn_case_within(domain_from("plane=xy"), *family_named("invalid"), seed_of_kinds, i).collision;
    int beside = 0;
    for (const Vector3<double>* v : {&c.point, &c.normal, &c.a.position, &c.b.position, &c.a.velocity, &c.b.velocity}) {
      beside += (*v)[2] == 0 ? 0 : 1;
    }
    EXPECT_LE(beside, 1) << i;
  }
}

/// The share of the cases of a family, within the domain, that have this property.
double share_of(const std::string& within, const char* family, bool (*has)(const Collision&)) {
  constexpr std::uint64_t cases = 200;
  std::uint64_t count = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    count += has(drawn_case_within(domain_from(within), *family_named(family), seed_of_kinds, i).collision) ? 1 : 0;
  }
  return static_cast<double>(count) / static_cast<double>(cases);
}

double sine_of_approach(const Collision& c) {
  const Vector3<double> v = relative_velocity(c);
  return std::abs(dot(c.normal, v)) / (length(c.normal) * length(v));
}

// Families are about something that a later change to a kind would undo.
TEST(Kinds, KeepWhatFamiliesAreAbout) {
  const auto is_grazing = [](const Collision& c) { return sine_of_approach(c) < 0.2; };
  const auto is_head_on = [](const Collision& c) { return sine_of_approach(c) > 1 - 0x1p-20; };
  const auto is_resting = [](const Collision& c) { return dot(c.normal, relative_velocity(c)) == 0; };
  const auto is_central = [](const Collision& c) {
    const auto is_along = [&](const Body& body) {
      return body.immovable || features::are_parallel(features::lever_arm(c, body), c.normal);
    };
    return is_along(c.a) && is_along(c.b);
  };
  for (const std::string& kind : some_kinds()) {
    EXPECT_GT(share_of(kind, "grazing", is_grazing), 0.9) << kind;
    EXPECT_GT(share_of(kind, "head_on", is_head_on), 0.9) << kind;
    EXPECT_GT(share_of(kind, "resting", is_resting), 0.9) << kind;
    EXPECT_GE(share_of(kind, "collinear_spheres", is_central), 0.9) << kind;
  }
}

TEST(Kinds, HoldTheQuestionsOfEachRelation) {
  for (const std::string& text : some_kinds()) {
    const Domain domain = domain_from(text);
    for (const Invariant& invariant : all_invariants()) {
      const auto* const about = std::get_if<AboutRelation>(&invariant.about);
      if (about == nullptr || !std::holds_alternative<AboutRelation::OfCollision>(about->ask)) {
        continue;
      }
      int inside = 0;
      for (std::uint64_t i = 0; i < 40; ++i) {
        const JudgedCase one(drawn_case_within(domain, *family_named("generic"), seed_of_kinds, i));
        const auto questions = one.questions_of(invariant, domain.kinds);
        inside +=
            std::ranges::all_of(
                questions, [&](const oracles::ExactCase& question) { return contains(domain, question.collision()); })
                ? 1
                : 0;
      }
      EXPECT_EQ(inside > 10, invariant.can_be_judged_in(domain.kinds))
          << text << ' ' << invariant.name << ' ' << inside;
    }
  }
}

TEST(Kinds, HoldShrunkCollisionsWithShortNumbers) {
  for (const std::string& text : some_kinds()) {
    const Domain domain = domain_from(text);
    int shrunk_cases = 0;
    for (std::uint64_t i = 0; i < 10; ++i) {
      const Collision c = drawn_case_within(domain, *family_named("generic"), seed_of_kinds, i).collision;
      const auto still_fails = [&](const Collision& candidate) {
        return is_approaching(candidate) && contains(domain, candidate);
      };
      if (!is_approaching(c)) {
        continue;
      }
      ++shrunk_cases;
      const Collision shrunk = shrink(c, still_fails, 4000, domain.kinds);
      EXPECT_EQ(name_outside(domain, shrunk), std::nullopt) << text;
      for (const Vector3<double>* v : {&shrunk.point, &shrunk.normal, &shrunk.a.position, &shrunk.b.position,
                                       &shrunk.a.velocity, &shrunk.b.velocity}) {
        for (const double x : *v) {
          EXPECT_EQ(x, rounded_to_bits(x, 6)) << text << ' ' << i << ' ' << v->transpose();
        }
      }
    }
    EXPECT_GT(shrunk_cases, 5) << text;
  }
}

}  // namespace
}  // namespace carom::properties
