// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/properties/families/body_pairs.hpp>
#include <carom/properties/features/compose.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/features/infeasible.hpp>
#include <carom/properties/features/seldom.hpp>
#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {
namespace {

bool is_colliding(const Collision& collision) {
  return validate(collision).empty() && oracles::ExactCase(collision).approach() == oracles::Approach::colliding;
}

TEST(Features, HaveNamesOfTheirOwnAndReasons) {
  std::set<std::string> names;
  for (const Feature& feature : all_features()) {
    EXPECT_TRUE(names.insert(feature.name).second) << feature.name;
    EXPECT_EQ(feature_named(feature.name), &feature);
    EXPECT_FALSE(feature.statement.empty()) << feature.name;
    EXPECT_FALSE(feature.why.empty()) << feature.name;
    EXPECT_EQ(feature.quantity.empty(), feature.kind != FeatureKind::magnitude) << feature.name;
  }
  EXPECT_GE(names.size(), 80U);
  EXPECT_EQ(feature_named("no_such_feature"), nullptr);
}

/// `Feature::make` succeeds in at least half of the collisions, and its results are valid.
TEST(Features, AreMade) {
  constexpr int tries = 40;
  for (const Feature& feature : all_features()) {
    int made = 0;
    for (std::uint64_t i = 0; i < tries; ++i) {
      Stream stream = case_stream(3, feature.name, i);
      Collision collision = general_bodies(stream).collision;
      feature.make(stream, collision);
      EXPECT_EQ(describe(validate(collision)), "") << feature.name;
      made += feature.is_present(collision) ? 1 : 0;
    }
    EXPECT_GE(2 * made, tries) << feature.name;
  }
}

TEST(Features, AreNotInEveryCollision) {
  constexpr int drawn = 200;
  std::map<std::string, int> present;
  for (std::uint64_t i = 0; i < drawn; ++i) {
    Stream stream = case_stream(4, "structured", i);
    for (const Feature* feature : features_of(structured_collision(stream))) {
      ++present[feature->name];
    }
  }
  for (const auto& [name, count] : present) {
    EXPECT_LT(count, drawn) << name;
  }
}

/// The indices of the features whose predicates hold.
std::vector<std::uint16_t> places_by_predicates(const Collision& collision) {
  std::vector<std::uint16_t> places;
  for (std::size_t i = 0; i < all_features().size(); ++i) {
    if (all_features()[i].is_present(collision)) {
      places.push_back(static_cast<std::uint16_t>(i));
    }
  }
  return places;
}

TEST(Features, AreFoundAsTheirPredicatesSay) {
  for (const Family& family : all_families()) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Collision collision = drawn_case(family, 1, i).collision;
      if (validate(collision).empty()) {
        EXPECT_EQ(feature_places_of(collision), places_by_predicates(collision)) << family.name << " #" << i;
      }
    }
  }
}

TEST(Features, AreFoundAtTheLimitsOfDecades) {
  Collision collision = drawn_case(*family_named("generic"), 1, 0).collision;
  ASSERT_FALSE(collision.a.immovable);
  for (int decade = -12; decade <= 12; ++decade) {
    const double limit = power_of_ten(decade);
    for (const double mass : {std::nextafter(limit, 0.0), limit, std::nextafter(limit, HUGE_VAL)}) {
      collision.a.mass = mass;
      EXPECT_EQ(feature_places_of(collision), places_by_predicates(collision)) << mass;
    }
  }
}

/// `make_both` makes no infeasible pair. The test omits pairs that the domain excludes by choice, and pairs of two
/// decades of one quantity.
TEST(Features, AreNotTogetherWherePairsAreInfeasible) {
  const std::set<std::string_view> by_choice{"masses are 10⁻⁹ to 10¹⁰ kg",
                                             "the contact would lie outside of the body, and K would have no bound",
                                             "a quantity lies in one decade only"};
  const std::span<const Feature> all = all_features();
  std::set<std::string_view> reasons;
  for (std::size_t x = 0; x < all.size(); ++x) {
    for (std::size_t y = x + 1; y < all.size(); ++y) {
      const std::string_view why = why_infeasible(all[x], all[y]);
      reasons.insert(why);
      for (std::uint64_t i = 0; i < 4 && !why.empty() && !by_choice.contains(why); ++i) {
        Stream stream = case_stream(5, all[x].name, i);
        Collision collision = i % 2 == 0 ? general_bodies(stream).collision : structured_collision(stream);
        const bool is_made =
            i < 2 ? make_both(stream, collision, all[x], all[y]) : make_both(stream, collision, all[y], all[x]);
        EXPECT_FALSE(is_made && is_colliding(collision)) << all[x].name << " with " << all[y].name << ": " << why;
      }
    }
  }
  for (const std::string_view reason : by_choice) {
    EXPECT_TRUE(reasons.contains(reason)) << reason;
  }
}

TEST(Features, AreAllThereInPairs) {
  const GateOptions defaults;
  FeatureCoverage coverage;
  for (const Family& family : all_families()) {
    for (std::uint64_t i = 0; i < cases_of(defaults, family); ++i) {
      const Collision collision = drawn_case(family, defaults.seed, i).collision;
      if (is_colliding(collision)) {
        coverage.add(feature_places_of(collision));
      }
    }
  }
  for (const auto& [x, y] : coverage.missing_pairs()) {
    ADD_FAILURE() << x->name << " with " << y->name << " is in no case";
  }
  EXPECT_EQ(coverage.met_pairs(), coverage.feasible_pairs());
  const std::span<const Feature> all = all_features();
  for (std::size_t x = 0; x < all.size(); ++x) {
    for (std::size_t y = x + 1; y < all.size(); ++y) {
      EXPECT_TRUE(is_feasible(x, y) || coverage.count(x, y) == 0)
          << all[x].name << " with " << all[y].name << ", said to be infeasible: " << why_infeasible(all[x], all[y]);
    }
  }
}

TEST(Features, ThatSeldomComeTogetherAreThereAndCan) {
  const auto place_of = [](const Feature* feature) {
    return static_cast<std::size_t>(feature - all_features().data());
  };
  EXPECT_GE(seldom_together().size(), 50U);
  for (const SeldomPair& pair : seldom_together()) {
    bool can = false;
    for (const Feature* first : pair.first) {
      for (const Feature* second : pair.second) {
        can = can || is_feasible(place_of(first), place_of(second));
      }
    }
    ASSERT_FALSE(pair.first.empty() || pair.second.empty());
    EXPECT_TRUE(can) << pair.first[0]->name << " with " << pair.second[0]->name;
  }
  EXPECT_EQ(features_beginning("near_head_on"), std::vector{feature_named("near_head_on")});
  EXPECT_EQ(features_beginning("a.moments_two").size(), 1U);
  EXPECT_THROW((void)features_beginning("near_head_off"), std::logic_error);
}

TEST(Features, AreMissedWhereNothingHasThem) {
  FeatureCoverage coverage;
  EXPECT_EQ(coverage.met_pairs(), 0U);
  Collision collision;
  collision.b.immovable = true;
  collision.a.velocity = {0, -1, 0};
  coverage.add(feature_places_of(collision));
  const auto place_of = [](std::string_view name) {
    return static_cast<std::size_t>(feature_named(name) - all_features().data());
  };
  EXPECT_EQ(coverage.count(place_of("a.orientation_identity")), 1U);
  EXPECT_EQ(coverage.count(place_of("normal_plus_y"), place_of("b.immovable")), 1U);
  EXPECT_EQ(coverage.count(place_of("b.immovable"), place_of("b.mass_one")), 0U);
  EXPECT_GT(coverage.missing_pairs().size(), 70000U);
  FeatureCoverage twice = coverage;
  twice += coverage;
  EXPECT_EQ(twice.count(place_of("normal_plus_y"), place_of("b.immovable")), 2U);
  EXPECT_EQ(twice.met_pairs(), coverage.met_pairs());
}

TEST(Features, OfAReportAreThoseThatItSays) {
  FeatureCoverage coverage;
  std::vector<std::uint64_t> counts;
  for (std::uint64_t i = 0; i < 20; ++i) {
    Stream stream = case_stream(1, "structured", i);
    coverage.add(feature_places_of(family_named("structured")->generate(stream).collision));
  }
  for (std::size_t i = 0; i < all_features().size(); ++i) {
    counts.push_back(coverage.count(i));
  }
  const auto missing = coverage.missing_pairs();
  ASSERT_FALSE(missing.empty());
  const FeatureCoverage reported = FeatureCoverage::reported(counts, missing);
  EXPECT_EQ(reported.met_pairs(), coverage.met_pairs());
  const auto same = reported.missing_pairs();
  ASSERT_EQ(same.size(), missing.size());
  for (std::size_t i = 0; i < same.size(); ++i) {
    EXPECT_EQ(same[i].x, missing[i].x);
    EXPECT_EQ(same[i].y, missing[i].y);
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    EXPECT_EQ(reported.count(i), counts[i]);
  }
}

}  // namespace
}  // namespace carom::properties
