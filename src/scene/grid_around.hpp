// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <carom/scene/cell_grid.hpp>

namespace carom::scene {

/// An empty grid for the spheres on these paths. The cells are as wide as the largest sphere, or wider if there would
/// be too many cells.
[[nodiscard]] inline CellGrid grid_around(const std::vector<Path>& paths) {
  if (paths.empty()) {
    return {};
  }
  double radius = 0;
  Vector3<double> least = Vector3<double>::Constant(never);
  Vector3<double> greatest = -least;
  for (const Path& path : paths) {
    radius = std::max(radius, path.radius);
    least = least.cwiseMin(path.position);
    greatest = greatest.cwiseMax(path.position);
  }
  const Vector3<double> extent = (greatest - least).array() + 2 * radius;
  const double share = std::cbrt(extent.prod() / static_cast<double>(paths.size()));
  const double width = std::max(2 * radius * (1 + 0x1p-16), 0.75 * share);
  CellGrid::Cell cells{};
  for (int axis = 0; axis < 3; ++axis) {
    cells[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::min(extent[axis] / width, 1048576.0)) + 2;
  }
  return {width, cells, paths.size()};
}

}  // namespace carom::scene
