// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
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

/// Two spheres meet again and again between two walls, off centre by a tenth of a radius.
Scene duel() {
  Scene scene = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 6);
  unit::add_plane(scene, {1, 0, 0}, {-4, 0, 0});
  unit::add_plane(scene, {-1, 0, 0}, {4, 0, 0});
  unit::add_sphere(scene, 0.5, {-2, 0.05, 0}, {1, 0, 0});
  unit::add_sphere(scene, 0.5, {2, 0, 0}, {-1, 0, 0});
  return scene;
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

/// A brick and a tetrahedron meet after 1.07 s. They would meet again after the end of the scene, at 1.35 s.
Scene meeting() {
  Scene scene = unit::empty_scene(Law::frictionless, {0.75, 0, 0, 0, 0}, 1.25);
  unit::add_polyhedron(scene, unit::centred_box({0.5, 0.75, 1}), {-2, 0.125, 0}, {1.25, 0, 0}, {1, 2, -0.5});
  unit::add_polyhedron(scene, unit::centred_tetrahedron(0.5), {2, 0, 0.0625}, {-1.25, 0, 0}, {-1, 0.5, 2});
  unit::add_plane(scene, {0, 0, 1}, {0, 0, -6});
  return scene;
}

TEST(Planted, NothingIsFoundWhereNothingIsPlanted) {
  for (const auto& [scene, most_rounding] : {std::pair(duel(), 1e-13L), {table(), 1e-13L}, {meeting(), 1e-14L}}) {
    const unit::WatchedRun run(scene, 1000);
    EXPECT_GT(run.simulation.counts().impacts, 0U);
    unit::expect_sound(run);
    EXPECT_LE(run.relative_rounding(), most_rounding);
  }
}

/// A defect of the first impact of a scene, and what the check of validity finds.
struct Planted {
  const char* what;
  Scene scene;
  std::function<void(Event&)> change;  // empty to withhold the event
  const char* other;
  const char* found;
  enum class Expected { found, nothing_else, not_found } expected = Expected::found;
};

std::function<void(Event&)> turned_by(double angle) {
  return [angle](Event& event) {
    const Quaternion<double>& q = event.a.orientation;
    const Eigen::Quaterniond turned =
        Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector(0.6, 0, 0.8)));
    event.a.orientation = {turned.w(), turned.x(), turned.y(), turned.z()};
  };
}

std::function<void(Event&)> earlier_by(double time) {
  return [time](Event& event) { event.a.after.path.start -= time; };
}

/// The defect moves a sphere sideways, away from all other bodies.
std::function<void(Event&)> aside_by_ulps(int ulps) {
  return [ulps](Event& event) { event.a.after.path.position.z() += ulps * 0x1p-52 * 0.5; };
}

std::vector<Planted> defects_of_motion() {
  using enum Planted::Expected;
  // The run ends before a sphere reaches a wall, so no path jumps.
  Scene until_wall = duel();
  until_wall.duration = 2;
  Scene fast = unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 2);
  unit::add_sphere(fast, 0.5, {-1e6, 0.05, 0}, {1e6, 0, 0});
  unit::add_sphere(fast, 0.5, {0, 0, 0}, {0, 0, 0});
  return {
      {"an arc a billionth of a radius inside its neighbour", duel(),
       [](Event& event) {
         scene::Path& b = event.b->after.path;
         b.position += (event.a.after.path.position - b.position).normalized() * 1e-9 * b.radius;
       },
       "sphere", "overlap"},
      {"spheres that pass through each other", until_wall,
       [](Event& event) {
         for (scene::Change* change : {&event.a, &*event.b}) {
           change->after.path.velocity = change->before.path.velocity;
         }
       },
       "sphere", "overlap", nothing_else},
      {"an event that is left out", until_wall, {}, "sphere", "overlap", nothing_else},
      {"an event that is left out before others", duel(), {}, "itself", "jumps"},
      {"a fast sphere that passes through another", fast, {}, "sphere", "overlap", nothing_else},
      {"a path that jumps by 64 ulps", duel(), aside_by_ulps(64), "itself", "jumps"},
      {"a path that jumps by 4 ulps, within rounding", duel(), aside_by_ulps(4), "itself", "jumps", not_found},
      {"a time that runs back", duel(), [](Event& event) { event.a.after.path.start = 5.99; }, "itself",
       "ends before it begins"},
      {"a sphere of another radius", duel(),
       [](Event& event) { event.a.after.path.radius = std::nextafter(event.a.after.path.radius, 0.0); }, "itself",
       "radius"},
      {"an event of polyhedra that is left out", meeting(), {}, "polyhedron 1", "overlap", nothing_else},
      // A move by 10⁻¹³ m, hundreds of ulps of the position, is a jump but no overlap. A gap at a contact is at most
      // 2⁻³⁰ radii, so a move by 4·10⁻⁹ m is an overlap.
      {"a polyhedron moved by 1e-13 m", meeting(), [](Event& event) { event.b->after.path.position.y() += 1e-13; },
       "itself", "its path jumps", nothing_else},
      {"a polyhedron moved by 4e-9 m", meeting(),
       [](Event& event) { event.b->after.path.position += 4e-9 * event.collision.normal.normalized(); }, "polyhedron 1",
       "overlap"},
      {"an orientation turned by 1e-11 rad", meeting(), turned_by(1e-11), "itself", "its orientation jumps"},
      {"an orientation turned by 1e-9 rad", meeting(), turned_by(1e-9), "itself", "its orientation jumps"},
      {"an orientation turned by 1 rad", meeting(), turned_by(1), "itself", "its orientation jumps"},
      {"an arc that begins 1e-9 s too early", meeting(), earlier_by(1e-9), "itself", "jumps"},
      {"an arc that begins 0.25 s too early", meeting(), earlier_by(0.25), "itself", "jumps"},
      {"an arc that begins 8 s too early", meeting(), earlier_by(8), "itself", "begins before"},
      {"an arc that begins 1e6 s too early", meeting(), earlier_by(1e6), "itself", "begins before"},
  };
}

TEST(Planted, ADefectOfMotionIsFound) {
  for (const Planted& planted : defects_of_motion()) {
    SCOPED_TRACE(planted.what);
    const unit::WatchedRun run(planted.scene, 100, unit::first_impact([&](Event& event) {
                                 if (planted.change) {
                                   planted.change(event);
                                 }
                                 return static_cast<bool>(planted.change);
                               }));
    const Validity validity = run.validity();
    EXPECT_EQ(unit::has(validity, planted.other, planted.found), planted.expected != Planted::Expected::not_found)
        << unit::text_of(validity);
    if (planted.expected == Planted::Expected::nothing_else) {
      for (const Invalidity& one : validity.invalid) {
        EXPECT_NE(one.other.find(planted.other), std::string::npos) << unit::text_of(validity);
      }
    }
  }
}

TEST(Validity, SaysThatItsCheckEndedEarly) {
  for (const Scene& scene : {duel(), meeting()}) {
    const unit::WatchedRun run(scene, 1000);
    EXPECT_TRUE(run.validity().is_complete);
    EXPECT_FALSE(check_validity(scene, run.history, [] { return true; }).is_complete);
  }
}

TEST(Planted, AVelocityThatChangesWithoutACauseDoesNotClose) {
  for (const Scene& scene : {table(), meeting()}) {
    for (int kind = 0; kind < 4; ++kind) {
      const unit::WatchedRun run(scene, 1000, unit::first_impact([kind](Event& event) {
                                   scene::Change& change = kind % 2 == 0 ? event.a : *event.b;
                                   Vector& velocity =
                                       kind < 2 ? change.after.turning.angular_velocity : change.after.path.velocity;
                                   velocity *= 1 + 1e-9;
                                   return true;
                                 }));
      EXPECT_FALSE(run.ledger.is_closed()) << kind;
      // The impulses are right, so only the ledger finds this defect.
      EXPECT_EQ(run.judge.violated(), 0U);
    }
  }
}

/// The bound of the energy of an impact is a few hundred unit roundoffs of its energy.
TEST(Planted, AVelocityThatIsOffByAFewTimesTheBoundOfItsEventDoesNotClose) {
  for (const Scene& scene : {duel(), table(), meeting()}) {
    const unit::WatchedRun run(scene, 1000, unit::first_impact([](Event& event) {
                                 event.a.after.path.velocity *= 1 + 4096 * scene::roundoff;
                                 return true;
                               }));
    EXPECT_GT(run.ledger.worst_rounding(), 1);
    EXPECT_LT(run.ledger.worst_rounding(), 32);
  }
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
    EXPECT_EQ(unit::has(run.validity(), "plane 0", "not above"), below);
  }
}

/// An arc starts and ends below a ceiling, and crosses it in between.
TEST(Planted, AnArcThatCrossesAPlaneBetweenItsEndsIsFound) {
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
  EXPECT_TRUE(unit::has(found, "plane 1", "not above"));
}

TEST(Ledger, BooksEachCauseOfALossOnATable) {
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

TEST(Planted, ALossOtherThanThatOfTheMaterialsDoesNotClose) {
  struct Loss {
    const char* what;
    std::function<bool(const Event&)> has;
    std::function<void(Event&)> change;  // of the first event that has the loss
  };
  const auto ends = [](scene::Phase phase) {
    return
        [phase](const Event& event) { return event.kind == EventKind::phase && event.a.before.turning.phase == phase; };
  };
  const auto is = [](EventKind kind) { return [kind](const Event& event) { return event.kind == kind; }; };
  const auto decelerate = [](Event& event) { event.a.before.path.acceleration *= 1 + 1e-6; };
  const auto rebound = [](Event& event) { event.collision.restitution += 1e-9; };
  for (const Loss& loss :
       {Loss{"sliding", ends(scene::Phase::sliding), decelerate},
        {"rolling", ends(scene::Phase::rolling), decelerate},
        {"spinning", [](const Event& event) { return event.a.before.turning.angular_acceleration.z() != 0; },
         [](Event& event) { event.a.before.turning.angular_acceleration.z() *= 1 + 1e-6; }},
        {"an impact", is(EventKind::impact), rebound},
        {"an impact with a plane", is(EventKind::plane_impact), rebound}}) {
    bool is_changed = false;
    const unit::WatchedRun run(table(), 1000, [&](Event& event) {
      if (!is_changed && loss.has(event)) {
        is_changed = true;
        loss.change(event);
      }
      return true;
    });
    EXPECT_TRUE(is_changed) << loss.what;
    EXPECT_FALSE(run.ledger.is_closed()) << loss.what;
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

TEST(Planted, APolyhedronThatGoesThroughAPlaneIsFound) {
  Scene scene = meeting();
  scene.duration = 2;
  scene.planes[0].point.z() = -1.25;
  scene.polyhedra.pop_back();
  scene.polyhedra[0].velocity = {0, 0, -1};
  const auto leave_out = [](Event&) { return false; };
  const unit::WatchedRun run(scene, 100, leave_out);
  EXPECT_GT(run.simulation.counts().plane_impacts, 0U);
  EXPECT_TRUE(unit::has(run.validity(), "plane 0", "behind")) << unit::text_of(run.validity());
}

TEST(Planted, AnImpactWhereNothingTouchesIsFound) {
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
    EXPECT_EQ(unit::has(run.validity(), "itself", "nothing touches"), kind > 0)
        << kind << unit::text_of(run.validity());
  }
}

TEST(Planted, ANaNIsFound) {
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
    EXPECT_TRUE(unit::has(run.validity(), "plane 0", "behind") || unit::has(run.validity(), "polyhedron 1", "overlap"))
        << kind << unit::text_of(run.validity());
  }
}

TEST(Planted, EnergyWithoutACauseDoesNotClose) {
  // The change of B's velocity in the outcome exceeds that of its arc by a billionth.
  const unit::WatchedRun greater(meeting(), 100, unit::first_impact([](Event& event) {
                                   event.outcome.b.velocity +=
                                       1e-9 * (event.outcome.b.velocity - event.collision.b.velocity);
                                   return true;
                                 }));
  EXPECT_FALSE(greater.ledger.is_closed());
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
    EXPECT_EQ(run.ledger.is_closed(), !is_silent);
  }
}

TEST(Ledger, BooksBallsAndPolyhedraTogether) {
  Scene scene = unit::empty_scene(Law::coulomb, {0.5, 0.25, 0, 0, 0}, 1.5);
  scene.gravity = {0, 0, -9.81};
  unit::add_plane(scene, {0, 0, 1}, {0, 0, 0});
  unit::add_sphere(scene, 0.25, {0, 0, 2}, {0.5, 0, 0});
  scene.spheres[0].angular_velocity = {1, 2, 3};
  unit::add_polyhedron(scene, unit::centred_box({1, 1, 1}), {0, 0, 0.75}, {0, 0, 0}, {0.5, 0, 0});
  const unit::WatchedRun run(scene, 100);
  EXPECT_GT(run.simulation.counts().impacts, 0U);
  EXPECT_EQ(run.validity().count, 0U) << unit::text_of(run.validity());
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
