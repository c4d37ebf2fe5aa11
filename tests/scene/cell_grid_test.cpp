// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <carom/scene/cell_grid.hpp>

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

}  // namespace
}  // namespace carom::scene
