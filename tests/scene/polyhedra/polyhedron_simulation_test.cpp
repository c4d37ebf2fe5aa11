// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <carom/scene/polyhedra/polyhedron_simulation.hpp>
#include <carom/scene/polyhedra/scene_simulation.hpp>
#include <carom/scene/polyhedra/valid_polyhedra.hpp>

#include "bodies.hpp"
#include "scene/scenes.hpp"

namespace carom::scene {
namespace {

using carom::unit::add_plane;
using carom::unit::add_polyhedron;
using carom::unit::add_sphere;
using carom::unit::box_of_bodies;
using carom::unit::centred_box;
using carom::unit::centred_tetrahedron;
using carom::unit::empty_scene;
using unit::Points;
using unit::Vector;

constexpr MaterialPair elastic{1, 0, 0, 0, 0};
constexpr double g = 9.81;

std::vector<Event> events_of(const Scene& scene, std::size_t most) {
  return carom::unit::events_of<PolyhedronSimulation>(scene, most);
}

MaterialPair with_restitution(double restitution) { return {restitution, 0, 0, 0, 0}; }

Quaternion<double> turn_about(const Vector& axis, double angle) {
  const Vector v = std::sin(angle / 2) * axis.normalized();
  return {std::cos(angle / 2), v.x(), v.y(), v.z()};
}

Scene over_a_floor(const Points& corners, const Vector& position, double restitution) {
  Scene scene = empty_scene(Law::frictionless, with_restitution(restitution), 3);
  scene.gravity = {0, 0, -g};
  add_plane(scene, {0, 0, 1}, {0, 0, 0});
  add_polyhedron(scene, corners, position);
  return scene;
}

const Points unit_cube = centred_box({1, 1, 1});
const double cube_radius = std::sqrt(0.75);

TEST(PolyhedronSimulation, ReboundsACubeThatFallsFlatUntilItWouldRest) {
  Scene scene = over_a_floor(unit_cube, {0, 0, 2.5}, 0.5);
  const std::vector<Event> events = events_of(scene, 200);
  ASSERT_EQ(events.size(), 200U);
  const double nearness = 1.01 * contact_tolerance * cube_radius;
  // The cube falls from 2 m until it is within the contact tolerance.
  EXPECT_LE(events[0].time, std::sqrt(2 * 2 / g));
  EXPECT_GE(events[0].time, std::sqrt(2 * (2 - nearness) / g));
  double speed = g * events[0].time;
  std::size_t bounce = 0;
  // The cube bounces until it rises by at most 10⁻⁶ of its radius R. The height 0.25ⁿ · 2 m reaches this limit at n =
  // 10.6.
  for (; bounce < 10; ++bounce) {
    const Event& event = events[bounce];
    EXPECT_EQ(event.kind, EventKind::plane_impact);
    EXPECT_FALSE(event.was_slow) << bounce;
    // The tolerance in the height of a fall changes the speed v by up to g tolerance/v. The rounding of g t adds 2⁻⁴⁸.
    EXPECT_NEAR(event.a.after.path.velocity.z(), speed / 2, g * nearness / speed + 0x1p-48) << bounce;
    speed = event.a.after.path.velocity.z();
    // The impact is at the middle of the face, except for a rounding error of 2⁻⁵³ in the lever arm.
    EXPECT_LE(event.a.after.turning.angular_velocity.norm(), 0x1p-46) << bounce;
    const double fall = events[bounce + 1].time - event.time;
    EXPECT_NEAR(fall, 2 * speed / g, nearness / speed + 0x1p-48) << bounce;
  }
  // After these bounces, each hop rises by at most 10⁻⁶ R, and a slow contact is elastic. Rounding gives the cube at
  // most 2⁻⁴⁶ rad/s per hop, so it stays flat.
  const double greatest = default_capture_height * cube_radius;
  int slow = 0;
  for (std::size_t hop = bounce + 1; hop < events.size(); ++hop) {
    const double up = events[hop].a.after.path.velocity.z();
    EXPECT_LE(up * up / (2 * g), greatest * (1 + 1e-9)) << hop;
    EXPECT_GT(up, 0) << hop;
    EXPECT_LE(events[hop].a.after.path.position.z(), 0.5 + nearness) << hop;
    EXPECT_GT(events[hop].a.after.path.position.z(), 0.5) << hop;
    if (events[hop].was_slow) {
      ++slow;
      EXPECT_NEAR(up, events[hop - 1].a.after.path.velocity.z(), g * nearness / up) << hop;
    }
  }
  EXPECT_GT(slow, 100);
  PolyhedronSimulation simulation(scene);
  try {
    while (simulation.advance() != nullptr) {
    }
    FAIL() << simulation.time();
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what())
                  .find(" s polyhedron 0 (body 0) and plane 0 (plane 0) would have to rest on each other"),
              std::string::npos)
        << error.what();
  }
}

/// By hand, the impulse is j = −(1 + ε) v / (1/m + ‖r × n‖²/I), with v the velocity along the floor's normal n and r
/// the lever arm. All moments I of the cube are m/6.
TEST(PolyhedronSimulation, TurnsACubeThatFallsOnItsFaceEdgeOrCornerAsTheLeverArmSays) {
  for (const Quaternion<double>& orientation :
       {Quaternion<double>(1, 0, 0, 0), turn_about({0, 1, 0}, 0.5), turn_about({1, 0, 0}, std::numbers::pi / 4),
        turn_about({1, 2, 3}, 1), turn_about({-3, 1, 0.5}, 2)}) {
    SCOPED_TRACE(testing::PrintToString(orientation.transpose()));
    Scene scene = over_a_floor(unit_cube, {3, -2, 4}, 0.75);
    scene.polyhedra[0].orientation = 7 * orientation;  // of any length
    const std::vector<Event> events = events_of(scene, 1);
    ASSERT_EQ(events.size(), 1U);
    const Matrix3<double> turn = unit::matrix_of(orientation);
    double lowest = 0;
    for (const Vector& corner : unit_cube) {
      lowest = std::min(lowest, (turn * corner).z());
    }
    Vector arm = Vector::Zero();
    int count = 0;
    for (const Vector& corner : unit_cube) {
      if ((turn * corner).z() < lowest + 1e-12) {
        arm += turn * corner;
        ++count;
      }
    }
    arm /= count;
    const Event& event = events[0];
    const double nearness = 1.01 * contact_tolerance * cube_radius;
    EXPECT_LE(event.time, std::sqrt(2 * (4 + lowest) / g) + 0x1p-50);
    EXPECT_GE(event.time, std::sqrt(2 * (4 + lowest - nearness) / g));
    const double speed = -g * event.time;
    const Vector torque = arm.cross(Vector(0, 0, 1));
    const double impulse = -1.75 * speed / (1 + 6 * torque.squaredNorm());  // the mass is 1
    // Lever arms have an error of half a tolerance. A speed of about 8 m/s and 1/I = 6 multiply this error.
    EXPECT_NEAR(event.a.after.path.velocity.z(), speed + impulse, 100 * nearness);
    EXPECT_LE((event.a.after.turning.angular_velocity - 6 * impulse * torque).norm(), 100 * nearness);
    EXPECT_EQ(event.a.after.path.velocity.x(), 0);
    EXPECT_LE((event.a.orientation - orientation).norm(), 1e-15);
  }
}

/// A rod moves away from a slab, but its rotation swings an end into the slab. The bounding spheres overlap from the
/// beginning, and their centres recede.
TEST(PolyhedronSimulation, FindsTheContactOfBodiesWhoseBoundingSpheresOverlapAndRecede) {
  for (const bool is_rod_first : {true, false}) {
    Scene scene = empty_scene(Law::frictionless, elastic, 3);
    const auto add_rod = [&] {
      add_polyhedron(scene, centred_box({0.125, 0.0625, 2}), {0, 0, 0}, {-0.0625, 0, 0}, {0, 1, 0});
    };
    const auto add_slab = [&] { add_polyhedron(scene, centred_box({0.125, 4, 4}), {0.5625, 0, 0}); };
    if (is_rod_first) {
      add_rod();
      add_slab();
    } else {
      add_slab();
      add_rod();
    }
    const std::vector<Event> events = events_of(scene, 1);
    ASSERT_EQ(events.size(), 1U);
    // The rod's corner (1/16, ·, 1) rotates about y: x = cos t/16 + sin t − t/16 reaches the slab's face at x = 1/2.
    const auto gap = [](double t) { return 0.5 - (std::cos(t) / 16 + std::sin(t) - t / 16); };
    double low = 0;
    double high = 1;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (gap(middle) > 0 ? low : high) = middle;
    }
    // The contact is early by at most the tolerance divided by the speed cos t − 1/16 − sin t/16 > 3/4.
    EXPECT_LE(events[0].time, low + 1e-15);
    EXPECT_GE(events[0].time, low - contact_tolerance / 0.75);
    EXPECT_EQ(events[0].kind, EventKind::impact);
  }
}

TEST(PolyhedronSimulation, KeepsTheBitsOfTheSpinsOfBallsWithoutFriction) {
  for (const Precision precision : {Precision::binary32, Precision::binary64, Precision::extended}) {
    SCOPED_TRACE(name_of(precision));
    int of_balls = 0;
    int with_polyhedra = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      Scene scene = box_of_bodies(Law::frictionless, {0.9, 0, 0, 0, 0}, 3, 5, seed, true);
      scene.precision = precision;
      scene.gravity = {0, 0, seed % 2 == 0 ? -g : 0};
      for (const Event& event : events_of(scene, 150)) {
        const auto check = [&](const Change& change) {
          if (change.body < scene.spheres.size()) {
            ASSERT_EQ(change.after.turning.angular_velocity, scene.spheres[change.body].angular_velocity)
                << "seed " << seed << ", at " << event.time << ", body " << change.body << " and "
                << (event.b ? "body " + std::to_string(event.b->body) : "a plane");
          }
        };
        check(event.a);
        if (event.b) {
          check(*event.b);
          of_balls += event.b->body < scene.spheres.size() ? 1 : 0;
          with_polyhedra += event.a.body < scene.spheres.size() && event.b->body >= scene.spheres.size() ? 1 : 0;
        }
      }
    }
    EXPECT_GT(of_balls, 5);
    EXPECT_GT(with_polyhedra, 50);
  }
}

/// The change of units multiplies all numbers of the run by powers of two, so they round in the same way.
TEST(PolyhedronSimulation, IsTheSameInEveryUnitOfLength) {
  Scene scene = box_of_bodies(Law::frictionless, with_restitution(0.75), 2, 1, 3, false);
  scene.gravity = {0, 0, -g};
  const std::vector<Event> events = events_of(scene, 60);
  ASSERT_GT(events.size(), 20U);
  for (const double scale : {0x1p-10, 0x1p10}) {
    SCOPED_TRACE(scale);
    Scene other = scene;
    other.gravity *= scale;
    for (Polyhedron& polyhedron : other.polyhedra) {
      polyhedron.position *= scale;
      polyhedron.velocity *= scale;
      for (Vector& vertex : polyhedron.vertices) {
        vertex *= scale;
      }
    }
    for (Plane& plane : other.planes) {
      plane.point *= scale;
    }
    ASSERT_FALSE(first_polyhedron_defect(other)) << describe(*first_polyhedron_defect(other));
    const std::vector<Event> others = events_of(other, 60);
    ASSERT_EQ(others.size(), events.size());
    for (std::size_t k = 0; k < events.size(); ++k) {
      ASSERT_EQ(events[k].time, others[k].time) << k;
      ASSERT_EQ(scale * events[k].a.after.path.velocity, others[k].a.after.path.velocity) << k;
    }
  }
}

std::string refusal_of(const Scene& scene, std::size_t most_events = 0) {
  try {
    PolyhedronSimulation simulation(scene);
    for (std::size_t k = 0; k < most_events && simulation.advance() != nullptr; ++k) {
    }
  } catch (const SceneError& error) {
    return error.what();
  }
  return "none";
}

TEST(PolyhedronSimulation, NamesTheBodiesThatOverlap) {
  Scene scene = empty_scene(Law::frictionless, elastic, 1);
  add_polyhedron(scene, unit_cube, {0, 0, 0});
  add_polyhedron(scene, unit_cube, {1.5, 0, 0});
  EXPECT_EQ(refusal_of(scene), "none");
  scene.polyhedra[1].position.x() = 0.75;
  EXPECT_TRUE(
      refusal_of(scene).starts_with("at t = 0 polyhedron 0 (body 0) and polyhedron 1 (body 1) may overlap: -0.25"))
      << refusal_of(scene);
}

/// A small ball of mass m bounces between two walls of mass M that approach each other, each at the speed V. The n-th
/// impact leaves the ball at the speed 2 n V. The walls slow down only after √(M/m)/4 impacts or more. All impacts are
/// at one instant, because the gaps are within the contact tolerance.
TEST(PolyhedronSimulation, EndsTheRunIfImpactsAtOneInstantDoNotEnd) {
  Scene scene = empty_scene(Law::frictionless, elastic, 1);
  const double nearly = 0.25 * contact_tolerance * 0x1p-4;
  add_sphere(scene, 0x1p-4, {0, 0, 0}, {0, 0, 0});
  add_polyhedron(scene, unit_cube, {-0.5 - 0x1p-4 - nearly, 0, 0}, {1, 0, 0});
  add_polyhedron(scene, unit_cube, {0.5 + 0x1p-4 + nearly, 0, 0}, {-1, 0, 0});
  for (Polyhedron& polyhedron : scene.polyhedra) {
    polyhedron.density = 1e9;
  }
  ASSERT_FALSE(first_polyhedron_defect(scene)) << describe(*first_polyhedron_defect(scene));
  const std::string refusal = refusal_of(scene, 1'000'000);
  EXPECT_TRUE(refusal.starts_with(
      "more than 10000 impacts at the instant t = 0; the last is of sphere 0 (ball 0) and polyhedron "))
      << refusal;
  // With walls of density 100 the impacts end.
  for (Polyhedron& polyhedron : scene.polyhedra) {
    polyhedron.density = 100;
  }
  EXPECT_EQ(refusal_of(scene, 1'000'000), "none");
}

/// Equal bodies fall from equal heights. Their distances from the origin are equal, because a position's error is
/// proportional to this distance.
TEST(PolyhedronSimulation, TakesTheLowerBodyFirstAtEqualTimes) {
  Scene scene = over_a_floor(unit_cube, {3, 0, 2}, 1);
  for (const Vector& position : {Vector(-3, 0, 2), Vector(0, 3, 2), Vector(0, -3, 2)}) {
    add_polyhedron(scene, unit_cube, position);
  }
  const std::vector<Event> events = events_of(scene, 8);
  ASSERT_EQ(events.size(), 8U);
  for (std::size_t k = 0; k < events.size(); ++k) {
    EXPECT_EQ(events[k].time, events[k - k % 4].time);
    EXPECT_EQ(events[k].a.body, k % 4);
  }
  EXPECT_GT(events[4].time, events[3].time);
}

void run_through_renewals(PolyhedronSimulation& simulation) {
  while (const Event* event = simulation.advance()) {
    ASSERT_EQ(event->kind, EventKind::renewal);
    EXPECT_FALSE(event->has_impulse);
    EXPECT_EQ(event->a.after.turning.angular_velocity, event->a.angular_velocity_before);
  }
}

/// The height of a body's lowest corner over the floor z = 0 at the impact.
double height_of(const Scene& scene, const Event& event) {
  const auto made = std::get<RigidBody>(rigid_body(scene.polyhedra[event.a.body]));
  const Matrix3<double> axes = unit::matrix_of(event.a.orientation);
  double least = std::numeric_limits<double>::infinity();
  for (const Vector& vertex : made.shape.core.vertices) {
    least = std::min(least, (event.a.after.path.position + axes * vertex).z());
  }
  return least;
}

/// The box rotates about its intermediate axis, so errors grow by a factor of e^0.48 per radian at first. Without
/// renewals, a rounding error of 2⁻⁵³ exceeds the contact tolerance, 2⁻³⁰, after 34 rad: e^(0.48 · 34) > 2²³.
TEST(PolyhedronSimulation, FindsTheContactOfABodyThatRotatesUnstably) {
  for (const double rate : {10.0, 30.0, 50.0, 100.0}) {
    Scene scene = empty_scene(Law::frictionless, elastic, 2);
    add_plane(scene, {0, 0, 1}, {0, 0, 0});
    add_polyhedron(scene, centred_box({0.2, 0.4, 0.6}), {0, 0, 1.5}, {0, 0, -1}, {1e-9 * rate, rate, 1e-9 * rate});
    const std::vector<Event> events = events_of(scene, 1);
    ASSERT_EQ(events.size(), 1U);
    const double radius = std::sqrt(0.01 + 0.04 + 0.09);
    EXPECT_GE(height_of(scene, events[0]), 0) << rate;
    EXPECT_LE(height_of(scene, events[0]), contact_tolerance * radius) << rate;
  }
}

/// Two rotating tetrahedra slide along each other with ε = 0, and parts of a face and an edge touch. They separate
/// along a direction that rotates with neither body (`way_out` in time_of_contact.cpp). A search without this direction
/// finds contacts at the same instant without end.
TEST(PolyhedronSimulation, EndsContactsOfFacesThatSlideAlongEachOther) {
  Scene scene = empty_scene(Law::rough, {0, 0.3, 0, 0, 0}, 0.0625);
  const auto add = [&](double half_edge, const Vector& position, const Quaternion<double>& orientation,
                       const Vector& velocity, const Vector& spin) {
    add_polyhedron(scene, centred_tetrahedron(half_edge), position, velocity, spin);
    scene.polyhedra.back().orientation = orientation;
  };
  add(0.13977478465842125, {-0.34600111012865614, -0.09941003266873685, 0.73395425284931},
      {0.5220504922275971, -0.8230562240853673, -0.10131372651905965, -0.19944238360509683},
      {0.1334725485649921, 0.518194184473293, 0.6284617686298304},
      {-0.13007183262759509, -1.1692631392391248, -0.5109565842630459});
  add(0.13283587038911188, {-0.24831778964310236, 0.05654198447980453, 0.8365269512725857},
      {0.3587447253611057, -0.2656116378886308, 0.8677758660821643, -0.2184438740021189},
      {-0.2979484030371741, 0.4780205007772823, 0.974625237638693},
      {1.1603080367502254, 0.28217092742775973, 0.5476500093978194});
  EXPECT_EQ(refusal_of(scene, 20'000), "none");
  EXPECT_GT(events_of(scene, 20'000).size(), 0U);
}

TEST(PolyhedronSimulation, HasNoEventWhereBodiesRestBesideEachOther) {
  Scene scene = empty_scene(Law::frictionless, elastic, 3);
  add_polyhedron(scene, unit_cube, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  add_polyhedron(scene, unit_cube, {1 + 0.5 * contact_tolerance * std::sqrt(0.75), 0, 0}, {0, 0, 0}, {0, 0, 0});
  PolyhedronSimulation simulation(scene);
  EXPECT_EQ(simulation.advance(), nullptr);
  EXPECT_EQ(simulation.time(), 3);
}

TEST(PolyhedronSimulation, EndsAtItsDurationAndRenewsRotationsIfNothingMeets) {
  Scene scene = empty_scene(Law::coulomb, {0.5, 0.5, 0, 0, 0}, 7);
  scene.gravity = {0, 0, -g};
  add_polyhedron(scene, unit_cube, {0, 0, 0}, {0, 0, 1}, {1, 2, 3});
  add_polyhedron(scene, centred_tetrahedron(1), {3, 0, 0}, {0.125, 0, 1}, {3, 2, 1});
  add_sphere(scene, 0.5, {-3, 0, 0}, {-0.125, 0, 1});
  PolyhedronSimulation simulation(scene);
  run_through_renewals(simulation);
  EXPECT_EQ(simulation.time(), 7);
  // Each polyhedron rotates by √14 · 7 = 26.2 rad.
  EXPECT_EQ(simulation.counts().renewals, 6U);
  EXPECT_EQ(simulation.counts().events, 6U);
  EXPECT_EQ(simulation.advance(), nullptr);
}

TEST(SceneSimulation, RunsTheLoopThatTheSceneNeedsAndHearsAStop) {
  Scene scene = empty_scene(Law::frictionless, elastic, 3);
  add_plane(scene, {0, 0, 1}, {0, 0, 0});
  add_sphere(scene, 0.5, {0, 0, 1.5}, {0, 0, -1});
  SceneSimulation spheres(scene);
  ASSERT_NE(spheres.advance(), nullptr);
  EXPECT_EQ(spheres.counts().advances, 0U);
  EXPECT_NEAR(spheres.time(), 1, 1e-14);
  add_polyhedron(scene, unit_cube, {3, 0, 1.25}, {0, 0, -1});
  SceneSimulation both(scene);
  EXPECT_EQ(both.size(), 2U);
  const Event* event = both.advance();
  ASSERT_NE(event, nullptr);
  EXPECT_EQ(event->a.body, 1U);
  EXPECT_NEAR(both.time(), 0.75, 1e-9);
  EXPECT_GT(both.counts().advances, 0U);
  EXPECT_EQ(both.state().bodies.size(), 2U);
  EXPECT_EQ(both.scene().polyhedra.size(), 1U);
  std::stop_source source;
  source.request_stop();
  both.stop_on(source.get_token());
  EXPECT_EQ(both.advance(), nullptr);
}

}  // namespace
}  // namespace carom::scene
