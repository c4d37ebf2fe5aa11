// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "runs.hpp"

/// Each test plants a defect in the history, in the ledger or in an impulse, and the checkers find it. Without a
/// defect, they find nothing.
namespace carom::properties {
namespace {

using scene::Event;
using scene::EventKind;
using scene::Scene;
using Vector = Vector3<double>;

bool has(const Validity& validity, const std::string& other, const std::string& what) {
  return std::any_of(validity.invalid.begin(), validity.invalid.end(), [&](const Invalidity& one) {
    return one.other.find(other) != std::string::npos && one.what.find(what) != std::string::npos;
  });
}

/// Two spheres meet again and again between two walls, off centre by a tenth of a radius.
Scene duel() {
  Scene scene = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 6);
  unit::add_plane(scene, {1, 0, 0}, {-4, 0, 0});
  unit::add_plane(scene, {-1, 0, 0}, {4, 0, 0});
  unit::add_sphere(scene, 0.5, {-2, 0.05, 0}, {1, 0, 0});
  unit::add_sphere(scene, 0.5, {2, 0, 0}, {-1, 0, 0});
  return scene;
}

TEST(Planted, NothingIsFoundWhereNothingIsPlanted) {
  const unit::WatchedRun run(duel(), 100);
  EXPECT_GT(run.simulation.counts().impacts, 0U);
  EXPECT_EQ(run.validity().count, 0U);
  EXPECT_LE(run.relative_rounding(), 1e-13L);
  EXPECT_EQ(run.judge.violated(), 0U);
}

TEST(Planted, AnArcABillionthOfARadiusInsideItsNeighbourIsFound) {
  const unit::WatchedRun run(duel(), 100, unit::first_impact([](Event& event) {
                               scene::Path& b = event.b->after.path;
                               b.position += (event.a.after.path.position - b.position).normalized() * 1e-9 * b.radius;
                               return true;
                             }));
  EXPECT_TRUE(has(run.validity(), "sphere", "overlap"));
  EXPECT_TRUE(has(run.validity(), "itself", "jumps"));
}

TEST(Planted, SpheresThatPassThroughEachOtherAreFound) {
  // The planted impact changes no velocity, and the run ends before a sphere reaches a wall. So no path jumps.
  Scene scene = duel();
  scene.duration = 2;
  const unit::WatchedRun run(scene, 100, unit::first_impact([](Event& event) {
                               for (scene::Change* change : {&event.a, &*event.b}) {
                                 change->after.path.velocity = change->before.path.velocity;
                               }
                               return true;
                             }));
  EXPECT_TRUE(has(run.validity(), "sphere", "overlap"));
  EXPECT_FALSE(has(run.validity(), "itself", ""));
}

TEST(Planted, AnEventThatIsLeftOutIsFound) {
  Scene scene = duel();
  scene.duration = 2;
  const unit::WatchedRun run(scene, 100, unit::first_impact([](Event&) { return false; }));
  EXPECT_TRUE(has(run.validity(), "sphere", "overlap"));
  EXPECT_FALSE(has(run.validity(), "itself", ""));
  const unit::WatchedRun longer(duel(), 100, unit::first_impact([](Event&) { return false; }));
  EXPECT_TRUE(has(longer.validity(), "itself", "jumps"));
}

TEST(Planted, APathThatJumpsIsFound) {
  for (const int ulps : {4, 64}) {
    // The defect moves a sphere sideways, away from all other bodies.
    const unit::WatchedRun run(duel(), 100, unit::first_impact([&](Event& event) {
                                 event.a.after.path.position.z() += ulps * 0x1p-52 * 0.5;
                                 return true;
                               }));
    EXPECT_EQ(has(run.validity(), "itself", "jumps"), ulps == 64) << ulps;
  }
}

TEST(Planted, ATimeThatRunsBackIsFound) {
  const unit::WatchedRun run(duel(), 100, unit::first_impact([](Event& event) {
                               event.a.after.path.start = 5.99;
                               return true;
                             }));
  EXPECT_TRUE(has(run.validity(), "itself", "ends before it begins"));
}

TEST(Planted, ASphereOfAnotherRadiusIsFound) {
  const unit::WatchedRun run(duel(), 100, unit::first_impact([](Event& event) {
                               event.a.after.path.radius = std::nextafter(event.a.after.path.radius, 0.0);
                               return true;
                             }));
  EXPECT_TRUE(has(run.validity(), "itself", "radius"));
}

TEST(Planted, ASphereAnUlpBelowAPlaneIsFound) {
  Scene scene = unit::empty_scene(Law::frictionless, {0, 0, 0, 0, 0}, 2);
  scene.gravity = {0, 0, -10};
  unit::add_plane(scene, {0, 0, 1}, {0, 0, 0});
  unit::add_plane(scene, {0, 3, 4}, {0, -40, -30});  // far away
  unit::add_sphere(scene, 0.75, {0, 0, 0.75 + 0.0625}, {1, 0, 0});
  for (const bool below : {false, true}) {
    const unit::WatchedRun run(scene, 100, [&](Event& event) {
      EXPECT_EQ(event.kind, EventKind::capture);
      if (below) {
        event.a.after.path.position.z() = std::nextafter(0.75, 0.0);
      }
      return true;
    });
    EXPECT_EQ(run.history.arcs()[0].size(), 2U);
    EXPECT_EQ(run.validity().count > 0, below);
    EXPECT_EQ(has(run.validity(), "plane 0", "not above"), below);
  }
}

/// An arc starts and ends below a ceiling, and crosses it in between.
TEST(Planted, ABulgeThroughACeilingIsFound) {
  Scene scene = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 0.875);
  scene.gravity = {0, 0, -8};
  // The sphere rises by 1 m in 1/2 s and falls almost back. Its top reaches z = 2 m.
  unit::add_sphere(scene, 0.5, {0, 0, 0.5}, {0, 0, 4});
  unit::add_plane(scene, {0, 0, 1}, {0, 0, 0});
  const unit::WatchedRun run(scene, 100);
  EXPECT_EQ(run.validity().count, 0U);
  // The checker reports an exact touch, so the plane is an ulp above the top of the sphere.
  unit::add_plane(scene, {0, 0, -1}, {0, 0, std::nextafter(2.0, 3.0)});
  EXPECT_EQ(check_validity(scene, run.history).count, 0U);
  scene.planes.back().point.z() = std::nextafter(2.0, 0.0);
  const Validity found = check_validity(scene, run.history);
  EXPECT_TRUE(has(found, "plane 1", "not above"));
}

Scene table() {
  Scene scene = unit::empty_scene(Law::rough, {0.9, 0.2, 0.25, 0.02, 0.05}, 20);
  scene.gravity = {0, 0, -9.81};
  unit::add_plane(scene, {0, 0, 1}, {0, 0, 0});
  unit::add_sphere(scene, 0.25, {-2, 0.1, 0.5}, {3, 0, 0});
  unit::add_sphere(scene, 0.25, {0, 0, 0.25}, {0, 0, 0});
  unit::add_sphere(scene, 0.25, {0.5, 0.25, 0.25}, {0, 0, 0});
  scene.spheres[0].angular_velocity = {0, -10, 5};
  return scene;
}

TEST(Planted, TheBooksOfATableCloseWithoutIt) {
  const unit::WatchedRun run(table(), 1000);
  EXPECT_LE(run.relative_rounding(), 1e-13L);
  EXPECT_EQ(run.validity().count, 0U);
  for (const Cause cause : {Cause::impacts, Cause::plane_impacts, Cause::sliding, Cause::rolling, Cause::spinning}) {
    EXPECT_LT(run.ledger.energy(cause), 0) << name_of(cause);
  }
  EXPECT_NEAR(
      static_cast<double>((run.ledger.present().translation + run.ledger.present().rotation) / run.ledger.scale()), 0,
      1e-12);
}

TEST(Planted, AVelocityThatChangesWithoutACauseDoesNotClose) {
  for (const bool turning : {false, true}) {
    const unit::WatchedRun run(table(), 1000, unit::first_impact([&](Event& event) {
                                 if (turning) {
                                   event.a.after.turning.angular_velocity *= 1 + 1e-9;
                                 } else {
                                   event.b->after.path.velocity *= 1 + 1e-9;
                                 }
                                 return true;
                               }));
    EXPECT_GT(run.relative_rounding(), 1e-12L);
  }
}

TEST(Planted, AnotherFrictionThanTheTablesDoesNotClose) {
  for (const scene::Phase phase : {scene::Phase::sliding, scene::Phase::rolling}) {
    int altered = 0;
    const unit::WatchedRun run(table(), 1000, [&](Event& event) {
      if (event.kind == EventKind::phase && event.a.before.turning.phase == phase && altered == 0) {
        ++altered;
        event.a.before.path.acceleration *= 1 + 1e-6;
      }
      return true;
    });
    EXPECT_EQ(altered, 1);
    EXPECT_GT(run.relative_rounding(), 1e-10L) << name_of(phase);
  }
  int altered = 0;
  const unit::WatchedRun run(table(), 1000, [&](Event& event) {
    if (event.a.before.turning.angular_acceleration.z() != 0) {
      ++altered;
      event.a.before.turning.angular_acceleration.z() *= 1 + 1e-6;
    }
    return true;
  });
  EXPECT_GT(altered, 0);
  EXPECT_GT(run.relative_rounding(), 1e-10L);
}

TEST(Planted, AnotherRestitutionThanTheRecordsDoesNotClose) {
  for (const EventKind kind : {EventKind::impact, EventKind::plane_impact}) {
    int altered = 0;
    const unit::WatchedRun run(table(), 1000, [&](Event& event) {
      if (event.kind == kind && altered == 0) {
        ++altered;
        event.collision.restitution += 1e-9;
      }
      return true;
    });
    EXPECT_EQ(altered, 1);
    EXPECT_GT(run.relative_rounding(), 1e-12L) << scene::name_of(kind);
  }
}

TEST(Planted, AnImpulseThatIsOffByABillionthIsViolated) {
  for (int component = 0; component < 12; ++component) {
    double time = 0;
    const unit::WatchedRun run(table(), 1000, unit::first_impact([&](Event& event) {
                                 time = event.time;
                                 const auto parts = vectors(event.outcome);
                                 double& number =
                                     (*parts.values[static_cast<std::size_t>(component / 3)])[component % 3];
                                 number += 1e-9;
                                 return true;
                               }));
    EXPECT_EQ(run.judge.violated(), 1U) << component;
    ASSERT_TRUE(run.judge.first_bad());
    EXPECT_EQ(run.judge.first_bad()->time, time);
    EXPECT_GT(run.judge.worst_backward_error(), 1000);
  }
}

TEST(ImpulseJudge, JudgesEveryNthImpulse) {
  std::vector<Event> events = unit::events_of(table(), 1000);
  ImpulseJudge third(Law::rough, Precision::binary64, 3, {});
  ImpulseJudge none(Law::rough, Precision::binary64, 0, {});
  std::uint64_t impulses = 0;
  for (const Event& event : events) {
    third.record(event);
    none.record(event);
    impulses += event.has_impulse ? 1 : 0;
  }
  EXPECT_GT(impulses, 3U);
  EXPECT_EQ(third.impulses(), impulses);
  EXPECT_EQ(third.judged(), (impulses + 2) / 3);
  EXPECT_EQ(none.judged(), 0U);
}

}  // namespace
}  // namespace carom::properties
