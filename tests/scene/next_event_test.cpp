// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <carom/scene/cell_grid.hpp>
#include <carom/scene/event_queue.hpp>
#include <carom/scene/exact_time.hpp>
#include <carom/scene/sphere_store.hpp>

#include "paths.hpp"

namespace carom::scene {
namespace {

using unit::path_of;
using unit::Vector;

std::vector<Path> random_paths(properties::Stream& stream, int count, double size, const Vector& acceleration) {
  std::vector<Path> paths;
  for (int i = 0; i < count; ++i) {
    paths.push_back(path_of(size * stream.vector(), 4 * stream.vector(), acceleration, stream.between(0.05, 0.5)));
  }
  return paths;
}

CellGrid grid_of(const std::vector<Path>& paths) {
  CellGrid grid = grid_around(paths);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    grid.put(static_cast<CellGrid::Index>(i), paths[i].position);
  }
  return grid;
}

/// The number of ordered pairs in contact at a time. Checks that these pairs are neighbours in the grid.
int count_touching(const CellGrid& grid, const std::vector<Path>& paths, double time) {
  int touching = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    std::multiset<CellGrid::Index> neighbours;
    grid.for_neighbours(static_cast<CellGrid::Index>(i), [&](CellGrid::Index j) { neighbours.insert(j); });
    EXPECT_EQ(neighbours.count(static_cast<CellGrid::Index>(i)), 0U);
    for (std::size_t j = 0; j < paths.size(); ++j) {
      const auto times = neighbours.count(static_cast<CellGrid::Index>(j));
      EXPECT_LE(times, 1U) << "a neighbour is given twice";
      const double distance = (position_at(paths[i], time) - position_at(paths[j], time)).norm();
      if (j != i && distance <= paths[i].radius + paths[j].radius) {
        ++touching;
        EXPECT_EQ(times, 1U) << i << " and " << j << " touch at " << time;
      }
    }
  }
  return touching;
}

TEST(CellGrid, GivesFewNeighboursWhereSpheresAreApart) {
  properties::Stream stream = properties::stream_from(2);
  const std::vector<Path> paths = random_paths(stream, 1000, 50, Vector::Zero());
  const CellGrid grid = grid_of(paths);
  std::size_t neighbours = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    grid.for_neighbours(static_cast<CellGrid::Index>(i), [&](CellGrid::Index) { ++neighbours; });
  }
  // A cell has 0.75³ of the volume per sphere, so 27 cells hold about 12 spheres. Other cells with the same lists add
  // about as many.
  EXPECT_LT(neighbours, 40 * paths.size());
}

TEST(CellGrid, GivesAllSpheresThatTouchAsNeighboursWhileSpheresMove) {
  properties::Stream stream = properties::stream_from(3);
  int touching = 0;
  int moves = 0;
  for (int run = 0; run < 6; ++run) {
    const Vector gravity = run % 2 == 0 ? Vector(0, 0, -9.81) : Vector(3, 0, 0);
    const std::vector<Path> paths = random_paths(stream, 60, 3, gravity);
    CellGrid grid = grid_of(paths);
    std::vector<CellGrid::Leaving> leaving;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      leaving.push_back(grid.leaving(static_cast<CellGrid::Index>(i), paths[i], 0));
    }
    double checked = 0;
    for (;;) {
      const auto next = std::min_element(leaving.begin(), leaving.end(),
                                         [](const auto& x, const auto& y) { return x.time < y.time; });
      for (; checked < std::min(next->time, 2.0); checked += 0.125) {
        touching += count_touching(grid, paths, checked);
      }
      if (next->time > 2) {
        break;
      }
      const auto sphere = static_cast<CellGrid::Index>(next - leaving.begin());
      const double now = next->time;
      grid.move(sphere, *next);
      *next = grid.leaving(sphere, paths[sphere], now);
      ASSERT_GE(next->time, now);
      ASSERT_LT(++moves, 100000) << "it moves to and fro";
    }
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(moves, 1000);
}

TEST(CellGrid, KeepsASphereAtRestInItsCell) {
  const std::vector<Path> paths{unit::resting({0.25, 0.25, 0.25}, 0.5)};
  CellGrid grid = grid_of(paths);
  EXPECT_EQ(grid.leaving(0, paths[0], 3).time, never);
  // A ball thrown up may leave the cell upwards, or downwards on its way back.
  const Path thrown = path_of({0.25, 0.25, 0.25}, {0, 0, 1}, {0, 0, -2}, 0.5);
  const double width = grid.width();
  const CellGrid::Leaving leaving = grid.leaving(0, thrown, 0);
  ASSERT_GT(width, 0.5);  // the top, 1/4 higher, is inside
  EXPECT_EQ(leaving.step, -1);
  EXPECT_EQ(leaving.axis, 2);
  EXPECT_NEAR(position_at(thrown, leaving.time).z(), 0, 4e-16);
}

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

TEST(EventQueue, GivesTheEarliestOfAListOfTimes) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const auto count = static_cast<std::size_t>(stream.integer(1, 40));
    EventQueue queue(count);
    std::vector<double> times(count, never);
    for (int change = 0; change < 200; ++change) {
      const auto index = static_cast<std::size_t>(stream.integer(0, static_cast<int>(count) - 1));
      const double time = stream.chance(5) ? never : stream.integer(0, 20) / 4.0;
      times[index] = time;
      queue.set(static_cast<EventQueue::Index>(index), time);
      ASSERT_TRUE(queue.time_of(static_cast<EventQueue::Index>(index)) == time) << seed;
      const auto least = std::min_element(times.begin(), times.end());
      ASSERT_TRUE(queue.first() == static_cast<EventQueue::Index>(least - times.begin())) << seed;
      const double latest = stream.integer(-1, 21) / 4.0;
      std::multiset<EventQueue::Index> expected;
      for (std::size_t k = 0; k < count; ++k) {
        if (times[k] <= latest) {
          expected.insert(static_cast<EventQueue::Index>(k));
        }
      }
      std::multiset<EventQueue::Index> found;
      queue.for_each_until(latest, [&](EventQueue::Index k) { found.insert(k); });
      ASSERT_TRUE(found == expected) << seed;
    }
  }
}

}  // namespace
}  // namespace carom::scene
