// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <carom/scene/arc.hpp>

namespace carom::scene {

/// Finds the spheres near a sphere (B. Lubachevsky, "How to simulate billiards and similar systems", J. Comput. Phys.
/// 94, 1991). The cells are cubes at least as wide as the largest sphere, so spheres that touch are in the same cell or
/// in adjacent ones. Only `put` and `move` change the cell of a sphere. Distant cells may share a list of spheres, so
/// the grid covers all of space. Sharing costs only time.
class CellGrid {
 public:
  using Index = std::uint32_t;
  using Cell = std::array<std::int64_t, 3>;

  struct Leaving {
    double time = never;
    int axis = 0;
    int step = 0;  // −1 or 1 along the axis
  };

  CellGrid() = default;
  /// `extent`: the number of cells along each axis that should have separate lists. Precondition: `width` [m] exceeds
  /// the largest diameter D by more than 10⁻⁶ D. This excess covers the rounding error of `Leaving::time`.
  CellGrid(double width, const Cell& extent, std::size_t spheres)
      : width_(width), next_(spheres, nobody), places_(spheres) {
    std::size_t lists = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::int64_t count = 4;  // the least power of two for which a cell and its neighbours have separate lists
      while (count < extent[axis] && lists * static_cast<std::size_t>(count) < 8 * spheres + 64) {
        count *= 2;
      }
      mask_[axis] = count - 1;
      lists *= static_cast<std::size_t>(count);
    }
    row_ = static_cast<std::size_t>(mask_[0] + 1) * 4;
    layer_ = row_ * static_cast<std::size_t>(mask_[1] + 1) / 2;
    blocks_.resize(lists / lists_in_a_block);
  }

  void put(Index sphere, const Vector3<double>& position) {
    for (int axis = 0; axis < 3; ++axis) {
      places_[sphere].cell[static_cast<std::size_t>(axis)] =
          static_cast<std::int64_t>(std::floor(position[axis] / width_));
    }
    link(sphere);
  }

  void move(Index sphere, const Leaving& leaving) {
    unlink(sphere);
    places_[sphere].cell[static_cast<std::size_t>(leaving.axis)] += leaving.step;
    link(sphere);
  }

  /// Calls use(j) for every other sphere in the same cell or in an adjacent one.
  template <class Use>
  void for_neighbours(Index sphere, const Use& use) const {
    // Collects the non-empty lists without a branch, which would be mispredicted every third time.
    std::array<Index, 27> firsts;
    std::size_t lists = 0;
    for_lists_around(sphere, [&](std::size_t list) {
      firsts[lists] = first(list);
      lists += firsts[lists] != nobody ? 1 : 0;
    });
    for (std::size_t k = 0; k < lists; ++k) {
      Index j = firsts[k];
      do {
        if (j != sphere) {
          use(j);
        }
        j = next_[j];
      } while (j != nobody);
    }
  }

  /// The time and the side at which the sphere's centre leaves its cell, up to rounding error.
  [[nodiscard]] Leaving leaving(Index sphere, const Path& path, double now) const {
    Leaving first;
    const Vector3<double> position = position_at(path, now);
    const Vector3<double> velocity = velocity_at(path, now);
    for (int axis = 0; axis < 3; ++axis) {
      const double low = static_cast<double>(places_[sphere].cell[static_cast<std::size_t>(axis)]) * width_;
      const double x = position[axis] - low;
      const double v = velocity[axis];
      const double a = path.acceleration[axis];
      for (const int step : {-1, 1}) {
        const double time = now + delay(step < 0 ? x : width_ - x, step * v, step * a);
        if (time < first.time) {
          first = {time, axis, step};
        }
      }
    }
    return first;
  }

  [[nodiscard]] Vector3<double> centre_of_cell(Index sphere) const {
    const Cell& cell = places_[sphere].cell;
    return {(static_cast<double>(cell[0]) + 0.5) * width_, (static_cast<double>(cell[1]) + 0.5) * width_,
            (static_cast<double>(cell[2]) + 0.5) * width_};
  }

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] std::size_t bytes() const {
    return blocks_.size() * sizeof(Block) + next_.size() * (sizeof(Index) + sizeof(Place));
  }

 private:
  static constexpr Index nobody = 0xffffffff;

  /// The first s ≥ 0 at which v s + a s²/2 exceeds `distance`.
  [[nodiscard]] static double delay(double distance, double v, double a) {
    if (a == 0) {
      return v > 0 ? std::max(0.0, distance / v) : never;
    }
    const double square = v * v + 2 * a * distance;
    if (a > 0) {
      return std::max(0.0, (std::sqrt(std::max(0.0, square)) - v) / a);
    }
    if (v <= 0 || square < 0) {
      return never;
    }
    return std::max(0.0, 2 * distance / (v + std::sqrt(square)));
  }

  /// A block holds the heads (first spheres) of 4 × 2 × 2 lists in one cache line. The heads of the 27 cells around a
  /// sphere lie in 6 blocks on average. Row by row, they would lie in more than 9 cache lines.
  static constexpr std::size_t lists_in_a_block = 16;
  struct alignas(64) Block {
    std::array<Index, lists_in_a_block> first;
    Block() { first.fill(nobody); }
  };
  [[nodiscard]] Index& first(std::size_t list) {
    return blocks_[list / lists_in_a_block].first[list % lists_in_a_block];
  }
  [[nodiscard]] Index first(std::size_t list) const {
    return blocks_[list / lists_in_a_block].first[list % lists_in_a_block];
  }
  template <class Use>
  void for_lists_around(Index sphere, const Use& use) const {
    const Cell& cell = places_[sphere].cell;
    std::array<std::array<std::size_t, 3>, 3> parts;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::int64_t step = -1; step <= 1; ++step) {
        parts[axis][static_cast<std::size_t>(step + 1)] = part(axis, cell[axis] + step);
      }
    }
    for (const std::size_t z : parts[2]) {
      for (const std::size_t y : parts[1]) {
        for (const std::size_t x : parts[0]) {
          use(x + y + z);
        }
      }
    }
  }
  /// The number of a cell's list is the sum of these parts over the three axes.
  [[nodiscard]] std::size_t part(std::size_t axis, std::int64_t coordinate) const {
    const auto k = static_cast<std::size_t>(coordinate & mask_[axis]);
    switch (axis) {
      case 0:
        return k % 4 + k / 4 * 16;
      case 1:
        return k % 2 * 4 + k / 2 * row_;
      default:
        return k % 2 * 8 + k / 2 * layer_;
    }
  }
  [[nodiscard]] std::size_t list_of(Index sphere) const {
    const Cell& cell = places_[sphere].cell;
    return part(0, cell[0]) + part(1, cell[1]) + part(2, cell[2]);
  }
  void link(Index sphere) {
    Index& before = first(list_of(sphere));
    next_[sphere] = before;
    places_[sphere].previous = nobody;
    if (before != nobody) {
      places_[before].previous = sphere;
    }
    before = sphere;
  }
  void unlink(Index sphere) {
    const Index previous = places_[sphere].previous;
    if (previous != nobody) {
      next_[previous] = next_[sphere];
    } else {
      first(list_of(sphere)) = next_[sphere];
    }
    if (next_[sphere] != nobody) {
      places_[next_[sphere]].previous = previous;
    }
  }

  struct Place {
    Cell cell{};
    Index previous = nobody;
  };

  double width_ = 1;
  Cell mask_{};
  std::size_t row_ = 0, layer_ = 0;  // lists in a row of blocks, and in a layer of blocks
  std::vector<Block> blocks_;
  std::vector<Index> next_;  // the next sphere of the list; not in Place, because searches read it often
  std::vector<Place> places_;
};

/// An empty grid for the spheres on these paths. The cells are as wide as the largest sphere, or wider if there would
/// be too many cells. They are at least of the given width.
[[nodiscard]] inline CellGrid grid_around(const std::vector<Path>& paths, double least_width = 0) {
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
  const double width = std::max({2 * radius * (1 + 0x1p-16), 0.75 * share, least_width});
  CellGrid::Cell cells{};
  for (int axis = 0; axis < 3; ++axis) {
    cells[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::min(extent[axis] / width, 1048576.0)) + 2;
  }
  return {width, cells, paths.size()};
}

}  // namespace carom::scene
