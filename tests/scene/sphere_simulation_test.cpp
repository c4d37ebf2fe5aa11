// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scenes.hpp"

namespace carom::scene {
namespace {

using Vector = Vector3<double>;

const MaterialPair elastic{1, 0, 0, 0, 0};

MaterialPair with_restitution(double restitution) { return {restitution, 0, 0, 0, 0}; }

TEST(SphereSimulation, HasNoEventWithoutSpheres) {
  EXPECT_TRUE(unit::events_of(unit::empty_scene(Law::frictionless, elastic, 5), 10).empty());
}

/// The simulation skips planes out of reach of a cell, and tests planes from the eighth on together. So ten planes that
/// nothing touches must change nothing.
TEST(SphereSimulation, IsUnchangedByPlanesFarAway) {
  const Scene box = unit::box_of_spheres(Law::frictionless, elastic, 4, 5, 11);
  Scene more = box;
  more.planes.clear();
  for (int k = 0; k < 10; ++k) {
    unit::add_plane(more, {1, 0.1 * k, -0.3}, {-50 - 10.0 * k, 0, 0});
  }
  more.planes.insert(more.planes.end(), box.planes.begin(), box.planes.end());
  const std::vector<Event> expected = unit::events_of(box, 2000);
  const std::vector<Event> found = unit::events_of(more, 2000);
  ASSERT_GT(expected.size(), 500U);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    ASSERT_EQ(found[k].time, expected[k].time) << k;
    ASSERT_EQ(found[k].a.body, expected[k].a.body) << k;
    ASSERT_EQ(found[k].a.after.path.velocity, expected[k].a.after.path.velocity) << k;
    if (expected[k].kind == EventKind::plane_impact) {
      ASSERT_EQ(found[k].plane, expected[k].plane + 10) << k;
    }
  }
}

TEST(SphereSimulation, BouncesAtTheTimesOfTheClosedForm) {
  const double g = 9.81;
  const double height = 1;
  const double restitution = 0.75;
  Scene scene = unit::empty_scene(Law::frictionless, with_restitution(restitution), 100);
  scene.gravity = {0, 0, -g};
  unit::add_plane(scene, {0, 0, 2}, {0, 0, 0});
  unit::add_sphere(scene, 0.5, {3, -2, 0.5 + height}, {0, 0, 0});
  const std::vector<Event> events = unit::events_of(scene, 1000);
  ASSERT_GE(events.size(), 11U);
  double time = std::sqrt(2 * height / g);
  double speed = g * time;
  for (std::size_t bounce = 0; bounce < 10; ++bounce) {
    EXPECT_EQ(events[bounce].kind, EventKind::plane_impact);
    // The two bounds of a time differ by about 2 · 28 u of the height's terms, divided by the speed (u is `roundoff`).
    // This difference is below 128 u = 2⁻⁴⁶. An event may be early by this difference. Then its speed is too small by g
    // times the difference.
    EXPECT_NEAR(events[bounce].time, time, static_cast<double>(bounce + 1) * 0x1p-46) << bounce;
    speed *= restitution;
    EXPECT_NEAR(events[bounce].a.after.path.velocity.z(), speed, static_cast<double>(bounce + 1) * g * 0x1p-46);
    EXPECT_EQ(events[bounce].a.after.path.velocity.x(), 0);
    time += 2 * speed / g;
  }
  // The ball bounces until it would rise by at most 10⁻⁶ R. The height ε²ⁿ h reaches this limit at n = 25.2….
  const Event& last = events.back();
  EXPECT_EQ(events.size(), 26U);
  EXPECT_EQ(last.kind, EventKind::capture);
  EXPECT_EQ(last.a.after.turning.phase, Phase::resting);
  EXPECT_EQ(last.a.after.path.velocity, Vector(0, 0, 0));
  EXPECT_EQ(last.a.after.path.end, never);
  EXPECT_GE(last.a.after.path.position.z(), 0.5);
  EXPECT_LE(last.a.after.path.position.z(), 0.5 + 0x1p-50);
}

TEST(SphereSimulation, HasNoEventWhereSpheresTouchAtRest) {
  Scene scene = unit::empty_scene(Law::rough, {0.5, 0.5, 0.5, 0.1, 0.1}, 10);
  for (int k = 0; k < 4; ++k) {
    unit::add_sphere(scene, 0.5, {1.0 * k, 0, 0}, {0, 0, 0});
  }
  unit::add_sphere(scene, 0.5, {0, 1, 0}, {0, 0, 0});
  unit::add_plane(scene, {0, 0, 1}, {0, 0, -0.5});
  EXPECT_TRUE(unit::events_of(scene, 10).empty());
}

TEST(SphereSimulation, HasNoImpactWhereSpheresOnlyGraze) {
  Scene scene = unit::empty_scene(Law::frictionless, elastic, 10);
  unit::add_sphere(scene, 0.5, {0, 0, 0}, {0, 0, 0});
  unit::add_sphere(scene, 0.25, {-3, 0.75, 0}, {1, 0, 0});
  unit::add_plane(scene, {0, -1, 0}, {0, 1, 0});  // the second sphere slides along this plane
  EXPECT_TRUE(unit::events_of(scene, 10).empty());
  scene.planes.clear();
  scene.spheres[1].position.y() = std::nextafter(0.75, 0.0);
  EXPECT_EQ(unit::events_of(scene, 10).size(), 1U);
}

TEST(SphereSimulation, NamesASphereThatOverlaps) {
  Scene scene = unit::empty_scene(Law::frictionless, elastic, 10);
  unit::add_sphere(scene, 0.5, {0, 0, 0}, {0, 0, 0});
  unit::add_sphere(scene, 0.5, {std::nextafter(1.0, 0.0), 0, 0}, {0, 0, 0});
  const auto message_of = [](const Scene& wrong) -> std::string {
    try {
      const SphereSimulation simulation(wrong);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_NE(message_of(scene).find("(ball 0) overlaps"), std::string::npos) << message_of(scene);
  scene.spheres[1].position.x() = 1;
  EXPECT_EQ(message_of(scene), "none");
  unit::add_plane(scene, {-1, 0, 0}, {std::nextafter(1.5, 0.0), 0, 0});
  EXPECT_NE(message_of(scene).find("(ball 1) overlaps"), std::string::npos) << message_of(scene);
}

TEST(SphereSimulation, PassesTheBlowOnThroughACradle) {
  Scene scene = unit::empty_scene(Law::frictionless, elastic, 4);
  unit::add_sphere(scene, 0.5, {-2, 0, 0}, {1, 0, 0});
  for (int k = 1; k < 5; ++k) {
    unit::add_sphere(scene, 0.5, {k - 1.0, 0, 0}, {0, 0, 0});
  }
  const std::vector<Event> events = unit::events_of(scene, 100);
  ASSERT_EQ(events.size(), 4U);
  for (std::uint32_t k = 0; k < 4; ++k) {
    EXPECT_EQ(events[k].a.body, k);
    EXPECT_EQ(events[k].b->body, k + 1);
    EXPECT_NEAR(events[k].time, 1, 128 * roundoff);
    EXPECT_EQ(events[k].a.after.path.velocity, Vector(0, 0, 0));
    EXPECT_EQ(events[k].b->after.path.velocity, Vector(1, 0, 0));
  }
}

std::string end_of(const Scene& scene) {
  SphereSimulation simulation(scene);
  try {
    while (simulation.advance() != nullptr) {
    }
  } catch (const SceneError& error) {
    return error.what();
  }
  return "duration";
}

TEST(SphereSimulation, EndsWhereASphereWouldRestOnAnotherBody) {
  for (const double restitution : {0.0, 0.5, 0.8, 0.95}) {
    Scene scene = unit::empty_scene(Law::rough, with_restitution(restitution), 100);
    scene.gravity = {0, 0, -9.81};
    unit::add_plane(scene, {0, 0, 1}, {0, 0, 0});
    unit::add_sphere(scene, 0.2, {0, 0, 0.2}, {0, 0, 0});
    unit::add_sphere(scene, 0.2, {0, 0, 0.7}, {0, 0, 0});
    EXPECT_NE(end_of(scene).find("sphere 0 (ball 0) and sphere 1 (ball 1) would have to rest on each other"),
              std::string::npos)
        << restitution << ' ' << end_of(scene);
    // A groove, in which a sphere rolls from one side to the other.
    scene.spheres.pop_back();
    scene.planes.clear();
    unit::add_plane(scene, {1, 0, 1}, {0, 0, -1});
    unit::add_plane(scene, {-1, 0, 1}, {0, 0, -1});
    EXPECT_NE(end_of(scene).find("would have to rest on each other"), std::string::npos) << end_of(scene);
    // A sphere that stays on a plane, or rolls against a wall, rests on nothing else.
    scene.planes.clear();
    scene.spheres[0].velocity = {1, 0, 0};
    unit::add_plane(scene, {1, 2, 3}, {0, 0, -1});
    EXPECT_EQ(end_of(scene), "duration");
  }
}

TEST(Patience, EndsIfNothingAdvancesOrAStopIsRequested) {
  const auto look = [](Patience& patience, double step) {
    for (int k = 0; k < 2000; ++k) {
      if (patience.is_over(1 + k * step)) {
        return true;
      }
    }
    return false;
  };
  Patience still(Patience::Clock::duration::zero());
  EXPECT_THROW((void)look(still, 0x1p-52), SceneError);
  Patience advancing(Patience::Clock::duration::zero());
  EXPECT_FALSE(look(advancing, 0x1p-30));
  std::stop_source source;
  advancing.stop_on(source.get_token());
  source.request_stop();
  EXPECT_TRUE(look(advancing, 1));
}

TEST(SphereSimulation, FollowsASphereThatFliesFar) {
  Scene scene = unit::empty_scene(Law::frictionless, elastic, 1e9);
  unit::add_sphere(scene, 0.5, {0, 0, 0}, {1e5, 0, 0});
  unit::add_sphere(scene, 0.5, {0, 2, 0}, {0, 0, 0});
  unit::add_sphere(scene, 0.5, {2e8, 0.25, 0}, {0, 0, 0});
  SphereSimulation simulation(scene);
  const Event* const event = simulation.advance();
  ASSERT_NE(event, nullptr);
  EXPECT_EQ(event->b->body, 2U);
  EXPECT_NEAR(event->time, 2e3, 1e-4);
  EXPECT_EQ(simulation.advance(), nullptr);
  EXPECT_EQ(simulation.time(), 1e9);
  EXPECT_LT(simulation.counts().crossings, 100'000U);
}

TEST(SphereSimulation, CountsATieAndTakesTheLowerSpheresFirst) {
  // One ball hits two balls at once.
  std::vector<std::size_t> order{0, 1, 2};
  do {
    Scene scene = unit::empty_scene(Law::frictionless, elastic, 4);
    scene.spheres.resize(3);
    const std::array<Vector, 3> positions{Vector(-3, 0, 0), Vector(0, 0.75, 0), Vector(0, -0.75, 0)};
    for (std::size_t k = 0; k < 3; ++k) {
      Sphere& sphere = scene.spheres[order[k]];
      sphere.radius = 0.5;
      sphere.position = positions[k];
      sphere.velocity = k == 0 ? Vector(1, 0, 0) : Vector(0, 0, 0);
    }
    SphereSimulation simulation(scene);
    std::vector<Event> events;
    for (int k = 0; k < 2; ++k) {
      const Event* const event = simulation.advance();
      ASSERT_NE(event, nullptr);
      events.push_back(*event);
    }
    EXPECT_GE(simulation.counts().exact.ties, 1U);
    const std::size_t low = std::min(order[1], order[2]);
    EXPECT_EQ(events[0].a.body, std::min(low, order[0]));
    EXPECT_EQ(events[0].b->body, std::max(low, order[0]));
    const std::size_t high = std::max(order[1], order[2]);
    EXPECT_EQ(events[1].a.body, std::min(high, order[0]));
    EXPECT_EQ(events[1].b->body, std::max(high, order[0]));
    // At the contact, the moving ball is at x = −√(1 − 0.75²). The three terms of the squared gap are up to 14, each
    // accurate to about 28 u. The root of the discriminant is 1.3, so the time is accurate to 2 · 3 · 14 · 28 u/1.3.
    EXPECT_NEAR(events[0].time, 3 - std::sqrt(0.4375), 2048 * roundoff);
    EXPECT_NEAR(events[1].time, events[0].time, 2048 * roundoff);
  } while (std::next_permutation(order.begin(), order.end()));
}

Scene gas(std::uint64_t seed, Law law) {
  Scene scene = unit::box_of_spheres(law, {1, 0.25, 0.5, 0, 0}, 2, 100, seed);
  scene.gravity = {0, 0, -1};
  return scene;
}

using Wide = long double;

/// The least s ≥ 0 at which c₀ + c₁ s + c₂ s² falls below 0.
Wide first_fall(Wide c0, Wide c1, Wide c2) {
  const Wide discriminant = c1 * c1 - 4 * c0 * c2;
  if (c1 >= 0 && c2 >= 0) {
    return never;
  }
  if (c1 < 0) {
    return discriminant <= 0 ? never : std::max<Wide>(0, 2 * c0 / (std::sqrt(discriminant) - c1));
  }
  return (c1 + std::sqrt(discriminant)) / (-2 * c2);
}

/// The next event and its time over all pairs and planes, without grid, queue or bounds.
struct Next {
  Wide time = never;
  std::uint32_t sphere = 0;
  std::optional<std::uint32_t> partner;
  std::uint32_t plane = 0;
};

Next next_of_all(const SphereSimulation& simulation) {
  const Scene& scene = simulation.scene();
  const Wide now = simulation.time();
  const auto position = [&](std::size_t k) -> Vector3<Wide> {
    const Path path = simulation.arc(k).path;
    const Wide s = now - path.start;
    return path.position.cast<Wide>() + s * (path.velocity.cast<Wide>() + s / 2 * path.acceleration.cast<Wide>());
  };
  const auto velocity = [&](std::size_t k) -> Vector3<Wide> {
    const Path path = simulation.arc(k).path;
    return path.velocity.cast<Wide>() + (now - path.start) * path.acceleration.cast<Wide>();
  };
  Next next;
  for (std::uint32_t a = 0; a < simulation.size(); ++a) {
    const Wide radius = scene.spheres[a].radius;
    for (std::uint32_t b = a + 1; b < simulation.size(); ++b) {
      const Vector3<Wide> d = position(a) - position(b);
      const Vector3<Wide> v = velocity(a) - velocity(b);
      const Wide radii = radius + scene.spheres[b].radius;
      const Wide time = now + first_fall(d.squaredNorm() - radii * radii, 2 * d.dot(v), v.squaredNorm());
      if (time < next.time) {
        next = {time, a, b, 0};
      }
    }
    for (std::uint32_t k = 0; k < scene.planes.size(); ++k) {
      const Vector3<Wide> n = scene.planes[k].normal.cast<Wide>();
      const Wide height = n.dot(position(a) - scene.planes[k].point.cast<Wide>()) - radius * n.norm();
      const Wide time = now + first_fall(height, n.dot(velocity(a)), n.dot(scene.gravity.cast<Wide>()) / 2);
      if (time < next.time) {
        next = {time, a, std::nullopt, k};
      }
    }
  }
  return next;
}

TEST(SphereSimulation, FindsTheEarliestEventOfAllPairsAndPlanes) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Scene scene = gas(seed, seed % 2 == 0 ? Law::frictionless : Law::rough);
    scene.gravity.z() = seed % 3 == 0 ? 0 : -1;
    SphereSimulation simulation(scene);
    for (int k = 0; k < 200; ++k) {
      const Next expected = next_of_all(simulation);
      const Event* const event = simulation.advance();
      ASSERT_NE(event, nullptr);
      ASSERT_EQ(event->a.body, expected.sphere) << "seed " << seed << ", event " << k;
      ASSERT_EQ(event->b.has_value(), expected.partner.has_value());
      if (event->b) {
        ASSERT_EQ(event->b->body, *expected.partner);
      } else {
        ASSERT_EQ(event->plane, expected.plane);
      }
      // The event is early only by rounding: 2⁻⁵⁰ of coordinates up to 2, at speeds of at least 10⁻³.
      EXPECT_LE(static_cast<Wide>(event->time), expected.time + 1e-15L * (1 + expected.time));
      EXPECT_NEAR(event->time, static_cast<double>(expected.time), 1e-11);
    }
  }
}

}  // namespace
}  // namespace carom::scene
