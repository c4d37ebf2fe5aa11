// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/features/compose.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {
namespace {

bool is_colliding(const Collision& collision) {
  return validate(collision).empty() && oracles::ExactCase(collision).state() == oracles::ContactState::colliding;
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
TEST(Features, AreMadeInMostCollisions) {
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

/// A near feature does not hold exactly, and moves away from it by the drawn distance.
TEST(NearFeatures, AreMadeAtEachDistance) {
  constexpr int greatest_exponent = 15;
  constexpr std::uint64_t tries = 300;
  for (const Feature& feature : all_features()) {
    if (feature.kind != FeatureKind::near) {
      continue;
    }
    std::set<int> exponents;
    for (std::uint64_t i = 0; i < tries; ++i) {
      Stream stream = case_stream(6, feature.name, i);
      Collision collision = general_bodies(stream).collision;
      feature.make(stream, collision);
      if (feature.is_present(collision)) {
        const double distance = feature.measure(collision);
        ASSERT_GE(distance, 0.25e-15) << feature.name;
        ASSERT_LE(distance, 0.25) << feature.name;
        exponents.insert(static_cast<int>(std::lround(-std::log10(distance))));
      }
    }
    // Rounding may take the nearest two to the feature.
    for (int k = 1; k <= greatest_exponent - 2; ++k) {
      EXPECT_TRUE(exponents.contains(k)) << feature.name << " at 10^-" << k;
    }
  }
}

TEST(NearFeatures, DoNotHoldWithTheFeatureItself) {
  const Family& family = *family_named("near_special");
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Collision collision = drawn_case(family, 1, i).collision;
    for (const Feature* near : features_of(collision)) {
      const std::size_t prefix = near->body == 0 ? 0 : 2;
      if (near->kind == FeatureKind::near) {
        const Feature* exact = feature_named(near->name.substr(0, prefix) + near->name.substr(prefix + 5));
        EXPECT_FALSE(exact != nullptr && exact->is_present(collision)) << near->name << " in case " << i;
      }
    }
  }
}

/// Each near feature, and nearly each pair of them, is in the cases of a default run.
TEST(NearFeatures, AreInTheirFamilyInPairs) {
  const Family& family = *family_named("near_special");
  FeatureCoverage coverage;
  for (std::uint64_t i = 0; i < cases_of({}, family); ++i) {
    coverage.add(feature_places_of(drawn_case(family, 1, i).collision));
  }
  std::uint64_t pairs = 0;
  std::uint64_t met = 0;
  for (std::size_t x = 0; x < all_features().size(); ++x) {
    if (all_features()[x].kind != FeatureKind::near) {
      continue;
    }
    EXPECT_GE(coverage.count(x), 50U) << all_features()[x].name;
    for (std::size_t y = 0; y < all_features().size(); ++y) {
      const bool is_other = all_features()[y].kind != FeatureKind::near || y < x;
      pairs += is_other ? 1 : 0;
      met += is_other && coverage.has_pair(x, y) ? 1 : 0;
    }
  }
  EXPECT_GE(static_cast<double>(met), 0.9 * static_cast<double>(pairs)) << met << " of " << pairs;
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

/// A default run has nearly every pair that a run with twenty times as many cases has.
TEST(Features, AreThereInNearlyAllPairsOfALongRun) {
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
  for (std::size_t i = 0; i < all_features().size(); ++i) {
    EXPECT_GE(coverage.count(i), 10U) << all_features()[i].name;
  }
  EXPECT_GE(100 * coverage.met_pairs(), 97 * pairs_of_long_run);
}

std::size_t place_of(std::string_view name) {
  return static_cast<std::size_t>(feature_named(name) - all_features().data());
}

TEST(Features, AreCountedWithTheirPairs) {
  FeatureCoverage coverage;
  EXPECT_EQ(coverage.met_pairs(), 0U);
  Collision collision;
  collision.b.immovable = true;
  collision.a.velocity = {0, -1, 0};
  const std::vector<std::uint16_t> present = feature_places_of(collision);
  coverage.add(present);
  EXPECT_EQ(coverage.count(place_of("a.orientation_identity")), 1U);
  EXPECT_TRUE(coverage.has_pair(place_of("normal_plus_y"), place_of("b.immovable")));
  EXPECT_FALSE(coverage.has_pair(place_of("b.immovable"), place_of("b.mass_one")));
  EXPECT_EQ(coverage.met_pairs(), present.size() * (present.size() - 1) / 2);
  FeatureCoverage twice = coverage;
  twice += coverage;
  EXPECT_EQ(twice.count(place_of("normal_plus_y")), 2U);
  EXPECT_EQ(twice.met_pairs(), coverage.met_pairs());
  std::swap(collision.a, collision.b);
  FeatureCoverage other;
  other.add(feature_places_of(collision));
  EXPECT_FALSE(other.has_pair(place_of("normal_plus_y"), place_of("b.immovable")));
  other += coverage;
  EXPECT_TRUE(other.has_pair(place_of("normal_plus_y"), place_of("b.immovable")));
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
  const std::string pairs = coverage.pairs();
  const std::optional<FeatureCoverage> reported = FeatureCoverage::reported(counts, pairs);
  ASSERT_TRUE(reported);
  EXPECT_EQ(reported->met_pairs(), coverage.met_pairs());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    EXPECT_EQ(reported->count(i), counts[i]);
    for (std::size_t j = 0; j < i; ++j) {
      ASSERT_EQ(reported->has_pair(j, i), coverage.has_pair(j, i));
    }
  }
  EXPECT_FALSE(FeatureCoverage::reported(counts, pairs.substr(1)));
  EXPECT_FALSE(FeatureCoverage::reported(counts, 'g' + pairs.substr(1)));
  counts.pop_back();
  EXPECT_FALSE(FeatureCoverage::reported(counts, pairs));
}

}  // namespace
}  // namespace carom::properties
