// SPDX-License-Identifier: BSL-1.0
#include "runs.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace carom::properties {
namespace {

using scene::Scene;

constexpr std::array laws{Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb};

std::string text_of(const Validity& validity) {
  std::string text;
  for (const Invalidity& one : validity.invalid) {
    text += "sphere " + std::to_string(one.body) + " and " + one.other + " from " + std::to_string(one.begin) + " to " +
            std::to_string(one.end) + ": " + one.what + "\n";
  }
  return text;
}

void check(const Scene& scene, std::size_t most_events) {
  ASSERT_FALSE(scene::first_defect(scene)) << scene::describe(*scene::first_defect(scene));
  const unit::WatchedRun run(scene, most_events);
  const Validity validity = run.validity();
  EXPECT_EQ(validity.count, 0U) << text_of(validity);
  // The gap at an impact comes from the error of d², with the distance d of the centres. Under gravity, d² is a quartic
  // of time. Its error is at most 264 u L², where L is the distance travelled: 44 m in 3 s. So the gap is at most 264 u
  // L²/(2 d) < 10⁻⁹ d, because d ≥ 0.4 m.
  EXPECT_LE(run.widest_gap, 1e-9);
  EXPECT_GT(validity.exact_pairs, 0U);
  EXPECT_GT(validity.joints, 50U);
  // Each entry of the ledger has a rounding error of about 10⁻¹⁵ (8 u of a few numbers), with a nearly random sign. The
  // sum of thousands of entries stays far below 10⁻¹².
  const long double scale = run.ledger.scale();
  EXPECT_LE(std::abs(run.ledger.energy(Cause::rounding)), 1e-12L * scale);
  long double sum = run.ledger.initial().total();
  for (const Cause cause : all_causes) {
    sum += run.ledger.energy(cause);
  }
  EXPECT_NEAR(static_cast<double>(sum / scale), static_cast<double>(run.ledger.present().total() / scale), 1e-15);
  EXPECT_EQ(run.judge.violated(), 0U) << run.judge.first_bad()->invariant << " at " << run.judge.first_bad()->time;
  EXPECT_GT(run.judge.judged(), 30U);
  EXPECT_EQ(run.judge.judged(), run.judge.impulses());
  EXPECT_FALSE(run.judge.times_held().empty());
}

class RandomBoxes : public testing::TestWithParam<Law> {};

TEST_P(RandomBoxes, AreValidAndBalanced) {
  std::uint64_t seed = 0;
  for (const double restitution : {0.0, 0.5, 1.0}) {
    for (const double gravity : {0.0, 9.81}) {
      SCOPED_TRACE("restitution " + std::to_string(restitution) + ", gravity " + std::to_string(gravity));
      Scene scene = unit::box_of_spheres(GetParam(), {restitution, 0.25, 0.5, 0.02, 0.01}, 3, 3, ++seed);
      scene.gravity = {0, 0, -gravity};
      check(scene, 400);
    }
  }
}

TEST_P(RandomBoxes, AreValidInEveryPrecision) {
  for (const Precision precision : {Precision::binary32, Precision::extended}) {
    SCOPED_TRACE(name_of(precision));
    Scene scene = unit::box_of_spheres(GetParam(), {0.75, 0.25, 0.5, 0, 0}, 2, 5, 77);
    scene.gravity = {-3, 0, 0};
    scene.precision = precision;
    const unit::WatchedRun run(scene, 100);
    const Validity validity = run.validity();
    EXPECT_EQ(validity.count, 0U) << text_of(validity);
    if (precision == Precision::binary32) {
      EXPECT_EQ(run.judge.violated(), 0U) << run.judge.first_bad()->invariant;
    }
    EXPECT_GT(run.judge.judged(), 30U);
  }
}

/// No body can rest on the slopes of this scene.
TEST_P(RandomBoxes, MayStandOnSlopes) {
  Scene scene = unit::box_of_spheres(GetParam(), {0.5, 0.25, 0.5, 0, 0}, 2, 2, 5);
  scene.gravity = {0, 0, -9.81};
  unit::add_plane(scene, {1, 0, 3}, {-1, 0, -0.5});
  unit::add_plane(scene, {0, -1, 2}, {0, 3, -0.25});
  check(scene, 300);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RandomBoxes, testing::ValuesIn(laws),
                         [](const auto& law) { return std::string(name_of(law.param)); });

}  // namespace
}  // namespace carom::properties
