// SPDX-License-Identifier: BSL-1.0
// Scenes with rows in contact, exact grazes, and balls that are pressed together.
#include <stop_token>

#include <gtest/gtest.h>

#include "properties/scenes/runs.hpp"

namespace carom::properties {
namespace {

using scene::MaterialPair;
using scene::Scene;

void expect_valid(const Scene& scene, std::size_t most_events = 20000) {
  const unit::WatchedRun run(scene, most_events);
  const Validity validity = run.validity();
  EXPECT_EQ(validity.count, 0U);
  for (const Invalidity& one : validity.invalid) {
    ADD_FAILURE() << one.body << " and " << one.other << " from " << one.begin << " to " << one.end << ": " << one.what;
  }
  EXPECT_EQ(run.judge.violated(), 0U);
  EXPECT_LE(run.relative_rounding(), 1e-12L);
}

/// After the impact, rounding errors let spheres approach at 10⁻¹⁶ m/s. So the lower and upper bounds of their contact
/// time are seconds apart. Between these bounds, spheres leave their cells (scene::CellGrid).
TEST(StructuredScenes, ABallStrikesARowThatTouchesWithoutRestitution) {
  for (const double restitution : {0.0, 0.25, 1.0}) {
    Scene scene = unit::empty_scene(Law::frictionless, {restitution, 0, 0, 0, 0}, 5);
    unit::add_sphere(scene, 0.5, {-3, 0, 0}, {1, 0, 0});
    unit::add_sphere(scene, 0.5, {0, 0, 0}, {0, 0, 0});
    unit::add_sphere(scene, 0.5, {1, 0, 0}, {0, 0, 0});
    expect_valid(scene);
  }
}

/// One pair approaches at 2⁻⁴⁴ m/s and touches at 1 s. The bounds of this time are 0.04 s apart. A second pair touches
/// at 1 − 2⁻¹⁰ s. A fast sphere passes through several cells, and hits a resting sphere at 1 − 2⁻⁶ s.
TEST(StructuredScenes, AFastSphereLeavesItsCellsWithinTheBoundsOfASlowContact) {
  Scene scene = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 0x1p22);
  unit::add_sphere(scene, 0.5, {0, 8, 0}, {0, 0, 0});
  unit::add_sphere(scene, 0.5, {1 + 0x1p-44, 8, 0}, {-0x1p-44, 0, 0});
  unit::add_sphere(scene, 0.5, {0, 4, 0}, {0, 0, 0});
  unit::add_sphere(scene, 0.5, {2 - 0x1p-10, 4, 0}, {-1, 0, 0});
  unit::add_sphere(scene, 0.5, {0, 0, 0}, {0, 0, 0});
  unit::add_sphere(scene, 0.5, {-1 - 1024 * (1 - 0x1p-6), 0, 0}, {1024, 0, 0});
  expect_valid(scene, 2);
}

/// The gap of the two spheres is 0 for one instant within their arcs, and never negative.
TEST(StructuredScenes, SpheresGrazeExactly) {
  Scene scene = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 5);
  unit::add_sphere(scene, 0.5, {-6, 0, 0}, {2, 0, 0});
  unit::add_sphere(scene, 0.5, {0, 1, 0}, {0, 0, 0});
  const unit::WatchedRun run(scene, 100);
  EXPECT_EQ(run.simulation.counts().events, 0U);
  EXPECT_EQ(run.validity().count, 0U);
}

TEST(StructuredScenes, BallsThatRollArePressedTogether) {
  for (const double restitution : {0.95, 1.0}) {
    const MaterialPair ball{restitution, 0, 0, 0, 0};
    Scene scene = unit::empty_scene(Law::rough, ball, 0.2);
    scene.materials = {"ball", "bed"};
    scene.pairs = scene::MaterialPairs(2);
    scene.pairs.set(0, 0, ball);
    scene.pairs.set(0, 1, {0.5, 0.2, 0, 0.01, 0});
    scene.gravity = {0, 0, -9.81};
    unit::add_plane(scene, {0, 0, 1}, {0, 0, 0});
    scene.planes.back().material = 1;
    unit::add_sphere(scene, 0.03125, {0, 0, 0.03125}, {0.01, 0.01, 0});
    scene.spheres.back().angular_velocity = {-0.32, 0.32, 0};
    unit::add_sphere(scene, 0.03125, {0, 0.0625, 0.03125}, {0, 0.01, 0});
    scene.spheres.back().angular_velocity = {-0.32, 0, 0};
    for (scene::Sphere& sphere : scene.spheres) {
      sphere.density = 1700;
    }
    expect_valid(scene, 2000);
  }
}

/// At 10⁶ m, an ulp of a position is 10⁻¹⁰ m. The ledger's scale includes m |g·x|, so its relative rounding stays
/// small.
TEST(StructuredScenes, FarFromTheOriginTheLedgerCloses) {
  Scene scene = unit::empty_scene(Law::rough, {0.75, 0.25, 0, 0.01, 0.001}, 4);
  scene.gravity = {0, 0, -9.81};
  const double far = 1e6;
  unit::add_plane(scene, {0, 0, 1}, {far, far, far});
  unit::add_sphere(scene, 0.5, {far, far, far + 2}, {1, 0.5, 0});
  unit::add_sphere(scene, 0.5, {far + 3, far, far + 1}, {-1, 0.25, 0});
  expect_valid(scene);
}

/// The sphere leaves cell after cell, and nothing else happens.
TEST(StructuredScenes, AStopIsHeardWhileNothingHappens) {
  Scene scene = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 1e17);
  unit::add_sphere(scene, 0.5, {0, 0, 0}, {1, 0, 0});
  scene::SphereSimulation simulation(scene);
  std::stop_source source;
  simulation.stop_on(source.get_token());
  source.request_stop();
  EXPECT_EQ(simulation.advance(), nullptr);
  EXPECT_LT(simulation.time(), 1e17);
}

}  // namespace
}  // namespace carom::properties
