// SPDX-License-Identifier: BSL-1.0
#include "runs.hpp"

#include <array>
#include <stop_token>
#include <string>

#include <gtest/gtest.h>

#include <carom/scene/polyhedra/valid_polyhedra.hpp>

namespace carom::properties {
namespace {

using scene::MaterialPair;
using scene::Scene;
using Vector = Vector3<double>;

constexpr std::array laws{Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb};

void check(const Scene& scene, std::size_t most_events) {
  ASSERT_FALSE(scene::first_defect(scene)) << scene::describe(*scene::first_defect(scene));
  const unit::WatchedRun run(scene, most_events);
  const Validity validity = unit::expect_sound(run);
  // The gap at an impact comes from the error of d², with the distance d of the centres. Under gravity, d² is a quartic
  // of time. Its error is at most 264 u L², where L is the distance travelled: 44 m in 3 s. So the gap is at most 264 u
  // L²/(2 d) < 10⁻⁹ d, because d ≥ 0.4 m.
  EXPECT_LE(run.widest_gap, 1e-9);
  EXPECT_GT(validity.exact_pairs, 0U);
  EXPECT_GT(validity.joints, 50U);
  EXPECT_GT(run.judge.judged(), 30U);
  EXPECT_FALSE(run.judge.times_held().empty());
}

class RandomBoxes : public testing::TestWithParam<Law> {};

TEST_P(RandomBoxes, OfSpheresAreSound) {
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

TEST_P(RandomBoxes, OfSpheresAndOfPolyhedraAreValidInEveryPrecision) {
  for (const bool has_polyhedra : {false, true}) {
    for (const Precision precision : {Precision::binary32, Precision::extended}) {
      SCOPED_TRACE(name_of(precision));
      const MaterialPair pair{0.75, 0.25, 0.5, 0, 0};
      Scene scene = has_polyhedra ? unit::box_of_bodies(GetParam(), pair, 2, 0.75, 7, true)
                                  : unit::box_of_spheres(GetParam(), pair, 2, 5, 77);
      scene.gravity = {has_polyhedra ? 0.0 : -3.0, 0, 0};
      scene.precision = precision;
      const unit::WatchedRun run(scene, has_polyhedra ? 60 : 100);
      EXPECT_EQ(run.validity().count, 0U) << unit::text_of(run.validity());
      EXPECT_EQ(run.judge.violated(), 0U) << run.judge.first_bad()->invariant;
      EXPECT_GT(run.judge.judged(), has_polyhedra ? 10U : 30U);
    }
  }
}

/// Spheres slide and roll down these slopes, and some would rest between them.
TEST_P(RandomBoxes, OfSpheresAreSoundOnSlopes) {
  Scene scene = unit::box_of_spheres(GetParam(), {0.5, 0.25, 0.5, 0, 0}, 2, 2, 5);
  scene.gravity = {0, 0, -9.81};
  unit::add_plane(scene, {1, 0, 3}, {-1, 0, -0.5});
  unit::add_plane(scene, {0, -1, 2}, {0, 3, -0.25});
  check(scene, 300);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RandomBoxes, testing::ValuesIn(laws),
                         [](const auto& law) { return std::string(name_of(law.param)); });

/// After the impact, rounding errors let spheres approach at 10⁻¹⁶ m/s. So the lower and upper bounds of their contact
/// time are seconds apart. Between these bounds, spheres leave their cells (scene::CellGrid).
TEST(StructuredScenes, AreSoundWhereABallStrikesARowThatTouches) {
  for (const double restitution : {0.0, 0.25, 1.0}) {
    Scene scene = unit::empty_scene(Law::frictionless, {restitution, 0, 0, 0, 0}, 5);
    unit::add_sphere(scene, 0.5, {-3, 0, 0}, {1, 0, 0});
    unit::add_sphere(scene, 0.5, {0, 0, 0}, {0, 0, 0});
    unit::add_sphere(scene, 0.5, {1, 0, 0}, {0, 0, 0});
    unit::expect_sound(unit::WatchedRun(scene, 20000));
  }
}

/// One pair approaches at 2⁻⁴⁴ m/s and touches at 1 s. The bounds of this time are 0.04 s apart. A second pair touches
/// at 1 − 2⁻¹⁰ s. A fast sphere passes through several cells, and hits a resting sphere at 1 − 2⁻⁶ s.
TEST(StructuredScenes, AreSoundWhereASphereLeavesItsCellsWithinTheBoundsOfASlowContact) {
  Scene scene = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 0x1p22);
  unit::add_sphere(scene, 0.5, {0, 8, 0}, {0, 0, 0});
  unit::add_sphere(scene, 0.5, {1 + 0x1p-44, 8, 0}, {-0x1p-44, 0, 0});
  unit::add_sphere(scene, 0.5, {0, 4, 0}, {0, 0, 0});
  unit::add_sphere(scene, 0.5, {2 - 0x1p-10, 4, 0}, {-1, 0, 0});
  unit::add_sphere(scene, 0.5, {0, 0, 0}, {0, 0, 0});
  unit::add_sphere(scene, 0.5, {-1 - 1024 * (1 - 0x1p-6), 0, 0}, {1024, 0, 0});
  unit::expect_sound(unit::WatchedRun(scene, 2));
}

TEST(StructuredScenes, AreSoundWhereBallsThatRollArePressedTogether) {
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
    unit::expect_sound(unit::WatchedRun(scene, 2000));
  }
}

/// At 10⁶ m, an ulp of a position is 10⁻¹⁰ m. The ledger's scale includes m |g·x|, so its relative rounding stays
/// small.
TEST(StructuredScenes, AreSoundFarFromTheOrigin) {
  Scene scene = unit::empty_scene(Law::rough, {0.75, 0.25, 0, 0.01, 0.001}, 4);
  scene.gravity = {0, 0, -9.81};
  const double far = 1e6;
  unit::add_plane(scene, {0, 0, 1}, {far, far, far});
  unit::add_sphere(scene, 0.5, {far, far, far + 2}, {1, 0.5, 0});
  unit::add_sphere(scene, 0.5, {far + 3, far, far + 1}, {-1, 0.25, 0});
  unit::expect_sound(unit::WatchedRun(scene, 20000));
}

/// The sphere leaves cell after cell, and nothing else happens.
TEST(SphereSimulation, HearsAStopWhileNothingHappens) {
  Scene scene = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 1e17);
  unit::add_sphere(scene, 0.5, {0, 0, 0}, {1, 0, 0});
  scene::SphereSimulation simulation(scene);
  std::stop_source source;
  simulation.stop_on(source.get_token());
  source.request_stop();
  EXPECT_EQ(simulation.advance(), nullptr);
  EXPECT_LT(simulation.time(), 1e17);
}

void check_tumbling(const Scene& scene, std::size_t most_events, std::size_t least_events) {
  const auto defect = scene::first_polyhedron_defect(scene);
  ASSERT_FALSE(defect) << describe(*defect);
  const unit::WatchedRun run(scene, most_events);
  const Validity validity = unit::expect_sound(run);
  const scene::Counts& counts = run.simulation.counts();
  EXPECT_GE(counts.events, least_events);
  EXPECT_GT(validity.pairs + validity.planes, 0U);
  EXPECT_EQ(validity.joints, 2 * counts.impacts + counts.plane_impacts + counts.renewals);
  // `unseen` is at most 2⁻³⁰ of the smaller radius, and a radius is at most 0.4 m.
  EXPECT_LE(validity.unseen, 0.4 * 0x1p-30);
  // A coordinate of a position is at most 2 m and has about eight roundings.
  EXPECT_LE(validity.largest_jump, 8 * 0x1p-52);
  EXPECT_GT(run.judge.judged(), least_events / 2);
  if (scene.law != Law::reflection) {
    for (const Cause cause : {Cause::impacts, Cause::plane_impacts}) {
      EXPECT_LE(run.ledger.energy(cause), 1e-12L * run.ledger.scale()) << name_of(cause);
    }
  }
}

class RandomRooms : public testing::TestWithParam<Law> {};

TEST_P(RandomRooms, OfPolyhedraAreSound) {
  std::uint64_t seed = 100;
  for (const double restitution : {0.0, 0.5, 1.0}) {
    for (const double gravity : {0.0, 9.81}) {
      ++seed;
      // `reflection` may create energy. Under gravity the impacts never end, so the energy would grow without limit.
      if (GetParam() == Law::reflection && gravity > 0) {
        continue;
      }
      SCOPED_TRACE("restitution " + std::to_string(restitution) + ", gravity " + std::to_string(gravity) + ", seed " +
                   std::to_string(seed));
      Scene scene = unit::box_of_bodies(GetParam(), {restitution, 0.25, 0.5, 0, 0}, 2, 0.75, seed, false);
      scene.gravity = {0, 0, -gravity};
      check_tumbling(scene, 60, 15);
    }
  }
}

TEST_P(RandomRooms, OfBallsAndPolyhedraAreSound) {
  const std::uint64_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Scene scene = unit::box_of_bodies(GetParam(), {0.75, 0.25, 0.5, 0, 0}, 2, 0.75, seed, true);
  ASSERT_FALSE(scene.spheres.empty());
  check_tumbling(scene, 60, 15);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RandomRooms, testing::ValuesIn(laws),
                         [](const auto& law) { return std::string(name_of(law.param)); });

/// A needle and a sheet, a thousand times as long as thin, tumble in a room.
TEST(SlenderBodies, OfAllSizesAreSound) {
  for (const double size : {1e-3, 1.0, 1e3}) {
    SCOPED_TRACE(size);
    Scene scene = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 5);
    unit::add_box(scene, 3 * size);
    unit::add_polyhedron(scene, unit::centred_box(Vector(1e-3, 1e-3, 1) * size), Vector(0.75, 0.75, 1) * size,
                         Vector(0.5, 0.25, -0.75) * size, {1, 2, 0.5});
    unit::add_polyhedron(scene, unit::centred_box(Vector(1, 1, 1e-3) * size), Vector(2, 2, 2) * size,
                         Vector(-0.25, 0.5, 0.25) * size, {0.25, -1, 2});
    scene.polyhedra[1].orientation = {1, 0.5, 0.25, 0};
    const unit::WatchedRun run(scene, 100);
    // The radius of the sheet is √½ of the size.
    EXPECT_LE(unit::expect_sound(run).unseen, 0.71 * 0x1p-30 * size);
    EXPECT_GT(run.simulation.counts().events, 10U);
  }
}

}  // namespace
}  // namespace carom::properties
