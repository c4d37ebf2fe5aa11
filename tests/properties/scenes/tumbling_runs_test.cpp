// SPDX-License-Identifier: BSL-1.0
// The checkers accept random scenes with polyhedra. In another scene, they find planted defects.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <carom/scene/polyhedra/valid_polyhedra.hpp>

#include "properties/scenes/runs.hpp"

namespace carom::properties::tumbling {
namespace {

using scene::Event;
using scene::EventKind;
using scene::Scene;
using Vector = Vector3<double>;

std::string text_of(const Validity& validity) {
  std::string text;
  for (const Invalidity& one : validity.invalid) {
    text += "body " + std::to_string(one.body) + " and " + one.other + " from " + std::to_string(one.begin) + " to " +
            std::to_string(one.end) + ": " + one.what + "\n";
  }
  return text;
}

void expect_sound(const Scene& scene, std::size_t most_events, std::size_t least_events) {
  const auto defect = scene::first_polyhedron_defect(scene);
  ASSERT_FALSE(defect) << describe(*defect);
  const unit::WatchedRun run(scene, most_events);
  EXPECT_GE(run.simulation.counts().events, least_events);
  const Validity validity = run.validity();
  EXPECT_EQ(validity.count, 0U) << text_of(validity);
  EXPECT_GT(validity.pairs, 0U);
  EXPECT_GT(validity.planes, 0U);
  EXPECT_EQ(validity.joints, 2 * run.simulation.counts().impacts + run.simulation.counts().plane_impacts +
                                 run.simulation.counts().renewals);
  // `unseen` is at most 2⁻³⁰ of the smaller radius, and a radius is at most 0.4 m.
  EXPECT_LE(validity.unseen, 0.4 * 0x1p-30);
  // A coordinate of a position is at most 2 m and has about eight roundings.
  EXPECT_LE(validity.largest_jump, 8 * 0x1p-52);
  // Each event rounds the states of two of the eight bodies, with a relative error of about 20 u.
  EXPECT_LE(run.relative_rounding(), 1e-12L);
  const long double scale = run.ledger.scale();
  long double sum = run.ledger.initial().total();
  for (const Cause cause : all_causes) {
    sum += run.ledger.energy(cause);
  }
  EXPECT_NEAR(static_cast<double>(sum / scale), static_cast<double>(run.ledger.present().total() / scale), 1e-15);
  EXPECT_EQ(run.judge.violated(), 0U) << run.judge.first_bad()->invariant << " at " << run.judge.first_bad()->time;
  EXPECT_EQ(run.judge.judged(), run.judge.impulses());
  EXPECT_GT(run.judge.judged(), least_events / 2);
  if (scene.law != Law::reflection) {
    for (const Cause cause : {Cause::impacts, Cause::plane_impacts}) {
      EXPECT_LE(run.ledger.energy(cause), 1e-12L * scale) << name_of(cause);
    }
  }
}

class RandomRooms : public testing::TestWithParam<Law> {};

TEST_P(RandomRooms, OfPolyhedraAreValidAndBalanced) {
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
      expect_sound(scene, 60, 15);
    }
  }
}

TEST_P(RandomRooms, OfBallsAndPolyhedraAreValidAndBalanced) {
  const std::uint64_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Scene scene = unit::box_of_bodies(GetParam(), {0.75, 0.25, 0.5, 0, 0}, 2, 0.75, seed, true);
  ASSERT_FALSE(scene.spheres.empty());
  expect_sound(scene, 60, 15);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RandomRooms,
                         testing::Values(Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb),
                         [](const auto& law) { return std::string(name_of(law.param)); });

/// A brick and a tetrahedron meet after 1.07 s. They would meet again after the end of the scene, at 1.35 s.
Scene meeting() {
  Scene scene = unit::empty_scene(Law::frictionless, {0.75, 0, 0, 0, 0}, 1.25);
  unit::add_polyhedron(scene, unit::centred_box({0.5, 0.75, 1}), {-2, 0.125, 0}, {1.25, 0, 0}, {1, 2, -0.5});
  unit::add_polyhedron(scene, unit::centred_tetrahedron(0.5), {2, 0, 0.0625}, {-1.25, 0, 0}, {-1, 0.5, 2});
  unit::add_plane(scene, {0, 0, 1}, {0, 0, -6});
  return scene;
}

bool has(const Validity& validity, const std::string& other, const std::string& what) {
  return std::any_of(validity.invalid.begin(), validity.invalid.end(), [&](const Invalidity& one) {
    return one.other.find(other) != std::string::npos && one.what.find(what) != std::string::npos;
  });
}

TEST(PlantedInATumble, NothingIsFoundWhereNothingIsPlanted) {
  const unit::WatchedRun run(meeting(), 100);
  EXPECT_EQ(run.simulation.counts().impacts, 1U);
  EXPECT_EQ(run.validity().count, 0U);
  EXPECT_LE(run.relative_rounding(), 1e-14L);
  EXPECT_LT(run.ledger.energy(Cause::impacts), -0.01L);
  EXPECT_EQ(run.judge.violated(), 0U);
}

TEST(PlantedInATumble, AnEventThatIsLeftOutIsFound) {
  const unit::WatchedRun run(meeting(), 100, unit::first_impact([](Event&) { return false; }));
  EXPECT_TRUE(has(run.validity(), "polyhedron 1", "overlap")) << text_of(run.validity());
  EXPECT_FALSE(has(run.validity(), "itself", ""));
}

TEST(PlantedInATumble, ABodyThatGoesThroughAPlaneIsFound) {
  Scene scene = meeting();
  scene.duration = 2;
  scene.planes[0].point.z() = -1.25;
  scene.polyhedra.pop_back();
  scene.polyhedra[0].velocity = {0, 0, -1};
  const auto leave_out = [](Event&) { return false; };
  const unit::WatchedRun run(scene, 100, leave_out);
  EXPECT_GT(run.simulation.counts().plane_impacts, 0U);
  EXPECT_TRUE(has(run.validity(), "plane 0", "behind")) << text_of(run.validity());
}

TEST(PlantedInATumble, APlaceThatIsMovedIsFound) {
  // A move by 10⁻¹³ m, hundreds of ulps of the position, is a jump but no overlap.
  const unit::WatchedRun jump(meeting(), 100, unit::first_impact([](Event& event) {
                                event.b->after.path.position.y() += 1e-13;
                                return true;
                              }));
  EXPECT_TRUE(has(jump.validity(), "itself", "its path jumps")) << text_of(jump.validity());
  EXPECT_EQ(jump.validity().count, 1U);
  // A gap at a contact is at most 2⁻³⁰ radii, so a move by 4·10⁻⁹ m is an overlap.
  const unit::WatchedRun overlap(meeting(), 100, unit::first_impact([](Event& event) {
                                   event.b->after.path.position += 4e-9 * event.collision.normal.normalized();
                                   return true;
                                 }));
  EXPECT_TRUE(has(overlap.validity(), "polyhedron 1", "overlap")) << text_of(overlap.validity());
}

TEST(PlantedInATumble, AnOrientationThatIsTurnedIsFound) {
  for (const double angle : {1e-11, 1e-9, 1.0}) {
    const unit::WatchedRun run(meeting(), 100, unit::first_impact([angle](Event& event) {
                                 const Quaternion<double>& q = event.a.orientation;
                                 const Eigen::Quaterniond turned =
                                     Eigen::Quaterniond(q[0], q[1], q[2], q[3]) *
                                     Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector(0.6, 0, 0.8)));
                                 event.a.orientation = {turned.w(), turned.x(), turned.y(), turned.z()};
                                 return true;
                               }));
    EXPECT_TRUE(has(run.validity(), "itself", "its orientation jumps")) << angle << text_of(run.validity());
  }
}

TEST(PlantedInATumble, AnImpactWhereNothingTouchesIsFound) {
  Scene scene = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 3);
  unit::add_plane(scene, {0, 0, 1}, {0, 0, 0});
  unit::add_polyhedron(scene, unit::centred_box({1, 1, 2}), {0, 0, 3}, {0, 0, 0}, {4, 0, 3});
  for (int kind = 0; kind < 3; ++kind) {
    const unit::WatchedRun run(scene, 1, [kind](Event& event) {
      EXPECT_EQ(event.kind, scene::EventKind::renewal);
      event.a.after.path.velocity.z() += kind == 1 ? 1e-9 : 0;
      event.a.after.turning.angular_velocity *= kind == 2 ? 1 + 1e-10 : 1;
      return true;
    });
    EXPECT_EQ(has(run.validity(), "itself", "nothing touches"), kind > 0) << kind << text_of(run.validity());
  }
}

TEST(PlantedInATumble, WhatIsNoNumberIsFound) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int kind = 0; kind < 3; ++kind) {
    const unit::WatchedRun run(meeting(), 100, unit::first_impact([=](Event& event) {
                                 if (kind == 0) {
                                   event.a.after.path.velocity.x() = nan;
                                 } else if (kind == 1) {
                                   event.a.after.turning.angular_velocity.x() = nan;
                                 } else {
                                   event.a.orientation[0] = nan;
                                 }
                                 return true;
                               }));
    EXPECT_TRUE(has(run.validity(), "plane 0", "behind") || has(run.validity(), "polyhedron 1", "overlap"))
        << kind << text_of(run.validity());
  }
}

TEST(PlantedInATumble, AVelocityThatChangesWithoutACauseDoesNotClose) {
  for (int kind = 0; kind < 4; ++kind) {
    const unit::WatchedRun run(meeting(), 100, unit::first_impact([kind](Event& event) {
                                 scene::Change& change = kind % 2 == 0 ? event.a : *event.b;
                                 if (kind < 2) {
                                   change.after.turning.angular_velocity *= 1 + 1e-9;
                                 } else {
                                   change.after.path.velocity *= 1 + 1e-9;
                                 }
                                 return true;
                               }));
    EXPECT_GT(run.relative_rounding(), 1e-12L) << kind;
    // The impulses are right, so only the ledger finds this defect.
    EXPECT_EQ(run.judge.violated(), 0U);
  }
}

TEST(PlantedInATumble, EnergyWithoutACauseDoesNotClose) {
  // A's change of velocity in the outcome exceeds that of its arc by a billionth.
  const unit::WatchedRun greater(meeting(), 100, unit::first_impact([](Event& event) {
                                   event.outcome.a.velocity +=
                                       1e-9 * (event.outcome.a.velocity - event.collision.a.velocity);
                                   return true;
                                 }));
  EXPECT_GT(greater.relative_rounding(), 1e-12L);
  EXPECT_EQ(greater.judge.violated(), 1U);
  // A body keeps hopping on the floor, because slow contacts push it. If `is_silent`, the first slow contact does not
  // report its push.
  Scene scene = unit::empty_scene(Law::frictionless, {0, 0, 0, 0, 0}, 1);
  scene.gravity = {0, 0, -9.81};
  unit::add_plane(scene, {0, 0, 1}, {0, 0, 0});
  unit::add_polyhedron(scene, unit::centred_box({1, 1, 1}), {0, 0, 0.625});
  for (const bool is_silent : {false, true}) {
    int slow = 0;
    const unit::WatchedRun run(scene, 50, [&](Event& event) {
      if (event.was_slow && slow++ == 0) {
        event.was_slow = !is_silent;
      }
      return true;
    });
    EXPECT_GT(slow, 10);
    EXPECT_EQ(run.relative_rounding() > 1e-12L, is_silent);
  }
}

TEST(PlantedInATumble, AnArcOutOfOrderIsFound) {
  for (const double earlier : {1e-9, 0.25, 8.0, 1e6}) {
    const unit::WatchedRun run(meeting(), 100, unit::first_impact([earlier](Event& event) {
                                 event.a.after.path.start -= earlier;
                                 return true;
                               }));
    const Validity validity = run.validity();
    EXPECT_TRUE(has(validity, "itself", earlier < 1 ? "jumps" : "begins before")) << earlier << text_of(validity);
  }
}

TEST(PlantedInATumble, BallsAndPolyhedraAreBookedTogether) {
  Scene scene = unit::empty_scene(Law::coulomb, {0.5, 0.25, 0, 0, 0}, 1.5);
  scene.gravity = {0, 0, -9.81};
  unit::add_plane(scene, {0, 0, 1}, {0, 0, 0});
  unit::add_sphere(scene, 0.25, {0, 0, 2}, {0.5, 0, 0});
  scene.spheres[0].angular_velocity = {1, 2, 3};
  unit::add_polyhedron(scene, unit::centred_box({1, 1, 1}), {0, 0, 0.75}, {0, 0, 0}, {0.5, 0, 0});
  const unit::WatchedRun run(scene, 100);
  EXPECT_GT(run.simulation.counts().impacts, 0U);
  EXPECT_EQ(run.validity().count, 0U) << text_of(run.validity());
  EXPECT_LE(run.relative_rounding(), 1e-13L);
  EXPECT_LT(run.ledger.energy(Cause::impacts), 0);
  EXPECT_LT(run.ledger.energy(Cause::plane_impacts), 0);
  EXPECT_GE(run.ledger.energy(Cause::slow_contacts), 0);
  for (const Cause cause : {Cause::sliding, Cause::rolling, Cause::spinning}) {
    EXPECT_EQ(run.ledger.energy(cause), 0) << name_of(cause);
  }
  Vector3<long double> momentum = Vector3<long double>::Zero();
  for (const scene::BodyState& body : run.simulation.state().bodies) {
    momentum += body.mass * velocity_at(body.arc.path, run.simulation.time()).cast<long double>();
  }
  const Vector3<long double> booked = run.ledger.initial_momentum() + run.ledger.gravity_impulse() +
                                      run.ledger.plane_impulse() + run.ledger.momentum_rounding();
  EXPECT_LE(static_cast<double>((momentum - booked).norm()), 1e-13);
  EXPECT_LE(static_cast<double>(run.ledger.momentum_rounding().norm()), 1e-13);
  // The lever arm of the ball ends on the ball. The lever arm of the polyhedron ends in the middle of the gap, at most
  // 2⁻³¹ radii from the ball.
  EXPECT_LE(static_cast<double>(run.ledger.angular_momentum_rounding()),
            0x1p-30 * static_cast<double>(run.ledger.angular_momentum_scale()) *
                static_cast<double>(run.simulation.counts().impacts));
  ASSERT_EQ(run.history.orientations().size(), 2U);
  EXPECT_TRUE(run.history.orientations()[0].empty());
  EXPECT_EQ(run.history.orientations()[1].size(), run.history.arcs()[1].size());
  EXPECT_EQ(run.history.arcs()[0].size() + run.history.arcs()[1].size(), 2 + 2 * run.simulation.counts().impacts +
                                                                             run.simulation.counts().plane_impacts +
                                                                             run.simulation.counts().renewals);
}

}  // namespace
}  // namespace carom::properties::tumbling
