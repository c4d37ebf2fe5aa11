// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/exact_time.hpp>
#include <carom/scene/sphere_store.hpp>

#include "paths.hpp"

namespace carom::scene {
namespace {

using unit::Vector;

/// Two spheres in flight, with different start times. Soon after `now`, their distance is the sum of their radii times
/// a factor in 1 ± `closeness`.
struct Flight {
  SphereStore store;
  Vector gravity{0, 0, 0};
  double now = 1;

  explicit Flight(properties::Stream& stream) {
    const double size = stream.power_of_ten(-2, 4);
    gravity = stream.chance(3) ? Vector(0, 0, 0) : Vector(0, 0, -10 * stream.unit());
    now = 1 + stream.unit() * stream.power_of_ten(0, 3);
    const double radius = stream.between(0.05, 0.5);
    const double other_radius = stream.chance(2) ? radius : stream.between(0.05, 0.5);
    const double closeness = stream.power_of_ten(-16, 0);
    const double ahead = stream.between(0.01, 1);
    const Vector velocity = stream.vector() * stream.power_of_ten(-2, 1);
    const Vector place = stream.vector() * size;
    const Vector normal = Vector(stream.vector()).normalized();
    const double distance = (radius + other_radius) * (1 + closeness * stream.between(-1, 1));
    Scene scene;
    scene.gravity = gravity;
    scene.spheres.resize(2);
    scene.spheres[0].radius = radius;
    scene.spheres[1].radius = other_radius;
    store = SphereStore(scene);
    set(0, now - stream.unit(), place, stream.vector(), ahead);
    set(1, now - stream.unit(), place + distance * normal, velocity, ahead);
  }

  void set(std::size_t sphere, double start, const Vector& target, const Vector& velocity, double ahead) {
    const double s = now + ahead - start;
    Arc arc;
    arc.path = unit::path_of(target - s * velocity + 0.5 * s * s * gravity, velocity - s * gravity, gravity,
                             store.type(sphere).radius, start);
    store.set_arc(sphere, arc);
  }
};

TEST(QuickLook, RejectsNoPairThatTouches) {
  int rejected = 0;
  int touching = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    Flight flight(stream);
    const Path a = flight.store.path(0);
    const Path b = flight.store.path(1);
    const double now = flight.now;
    const int sign = sign_of_gap(a, b, now);
    const std::optional<ExactTime> contact = sign < 0 ? std::nullopt : exact_contact(a, b, now);
    const double horizon = contact ? contact->bounds().latest : now + stream.between(0, 4);
    const auto look_until = [&](double own, double its) {
      flight.store.set_until(1, its);
      return QuickLook(state_at(a, now), a.radius, flight.gravity, flight.store.extent(now), now, own)
          .stays_apart(flight.store.track(1), b.radius);
    };
    if (sign < 0 || contact) {
      ++touching;
      ASSERT_TRUE(!look_until(horizon, never)) << seed;
      ASSERT_TRUE(!look_until(never, horizon)) << seed;
    }
    // The bounds of `stay_apart` are narrower, so `stay_apart` rejects every pair that the quick look rejects.
    const double before = now + (horizon - now) * (1 - stream.power_of_ten(-12, 0));
    if (look_until(before, never)) {
      ++rejected;
      const RelativeState pair(state_at(a, now), state_at(b, now), a.radius + b.radius);
      ASSERT_TRUE(pair.squared_gap() > pair.squared_gap_error()) << seed;
      ASSERT_TRUE(stay_apart(a, b, pair, now, before)) << seed;
      ASSERT_TRUE(sign >= 0) << seed;
      if (contact) {
        const bool is_before = ExactTime::at(before) < *contact;
        ASSERT_TRUE(is_before) << seed;
      }
    }
  }
  EXPECT_GT(touching, 500);
  EXPECT_GT(rejected, 100);
}

}  // namespace
}  // namespace carom::scene
