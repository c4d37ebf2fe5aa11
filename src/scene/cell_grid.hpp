// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <carom/scene/motion.hpp>

namespace carom::scene {

/// Which spheres are near each other: cubic cells at least as wide as the largest sphere, so that spheres that touch
/// are in the same or in adjacent ones. A sphere is in the cell that it was last moved to: the loop moves it whenever
/// its centre leaves (B. Lubachevsky, "How to simulate billiards and similar systems", J. Comput. Phys. 94, 1991).
/// Space has no bounds; cells far apart may share a list, which costs time and nothing else.
class CellGrid {
 public:
  using Index = std::uint32_t;
  using Cell = std::array<std::int64_t, 3>;

  struct Leaving {
    double time = never;
    int axis = 0;
    int step = 0;  // −1 or 1 along that axis
  };

  CellGrid() = default;
  /// `width` [m] is more than a millionth wider than the largest diameter: that is what the time of leaving, which is
  /// rounded, may be off by. `extent` in cells along each axis: how far apart cells have lists of their own.
  CellGrid(double width, const Cell& extent, std::size_t spheres)
      : width_(width), next_(spheres, nobody), previous_(spheres, nobody), cells_(spheres) {
    std::size_t lists = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::int64_t count = 4;  // neighbours on both sides have lists of their own
      while (count < extent[axis] && lists * static_cast<std::size_t>(count) < 8 * spheres + 64) {
        count *= 2;
      }
      mask_[axis] = count - 1;
      lists *= static_cast<std::size_t>(count);
    }
    first_.assign(lists, nobody);
  }

  void put(Index sphere, const Vector3<double>& position) {
    for (int axis = 0; axis < 3; ++axis) {
      cells_[sphere][static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(position[axis] / width_));
    }
    link(sphere);
  }

  void move(Index sphere, const Leaving& leaving) {
    unlink(sphere);
    cells_[sphere][static_cast<std::size_t>(leaving.axis)] += leaving.step;
    link(sphere);
  }

  /// Calls use(j) for every other sphere in the cell or in one beside it.
  template <class Use>
  void for_neighbours(Index sphere, const Use& use) const {
    const Cell& cell = cells_[sphere];
    std::array<std::array<std::size_t, 3>, 3> places;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::int64_t step = -1; step <= 1; ++step) {
        places[axis][static_cast<std::size_t>(step + 1)] = static_cast<std::size_t>((cell[axis] + step) & mask_[axis]);
      }
    }
    const auto nx = static_cast<std::size_t>(mask_[0] + 1);
    const auto ny = static_cast<std::size_t>(mask_[1] + 1);
    for (const std::size_t z : places[2]) {
      for (const std::size_t y : places[1]) {
        for (const std::size_t x : places[0]) {
          for (Index j = first_[x + nx * (y + ny * z)]; j != nobody; j = next_[j]) {
            if (j != sphere) {
              use(j);
            }
          }
        }
      }
    }
  }

  /// When the centre leaves its cell, but for rounding.
  [[nodiscard]] Leaving leaving(Index sphere, const Path& path, double now) const {
    Leaving first;
    const Vector3<double> position = position_at(path, now);
    const Vector3<double> velocity = velocity_at(path, now);
    for (int axis = 0; axis < 3; ++axis) {
      const double low = static_cast<double>(cells_[sphere][static_cast<std::size_t>(axis)]) * width_;
      const double x = position[axis] - low;
      const double v = velocity[axis];
      const double a = path.acceleration[axis];
      for (const int step : {-1, 1}) {
        // Distance to the wall on that side, and how it shrinks.
        const double time = now + delay(step < 0 ? x : width_ - x, step * v, step * a);
        if (time < first.time) {
          first = {time, axis, step};
        }
      }
    }
    return first;
  }

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] std::size_t bytes_per_sphere() const { return 2 * sizeof(Index) + sizeof(Cell); }

 private:
  static constexpr Index nobody = 0xffffffff;

  /// The first s ≥ 0 at which v s + a s²/2 goes beyond `distance`.
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

  [[nodiscard]] std::size_t list_of(Index sphere) const {
    const Cell& cell = cells_[sphere];
    const auto place = [&](std::size_t axis) { return static_cast<std::size_t>(cell[axis] & mask_[axis]); };
    return place(0) +
           static_cast<std::size_t>(mask_[0] + 1) * (place(1) + static_cast<std::size_t>(mask_[1] + 1) * place(2));
  }
  void link(Index sphere) {
    Index& first = first_[list_of(sphere)];
    next_[sphere] = first;
    previous_[sphere] = nobody;
    if (first != nobody) {
      previous_[first] = sphere;
    }
    first = sphere;
  }
  void unlink(Index sphere) {
    if (previous_[sphere] != nobody) {
      next_[previous_[sphere]] = next_[sphere];
    } else {
      first_[list_of(sphere)] = next_[sphere];
    }
    if (next_[sphere] != nobody) {
      previous_[next_[sphere]] = previous_[sphere];
    }
  }

  double width_ = 1;
  Cell mask_{};
  std::vector<Index> first_, next_, previous_;
  std::vector<Cell> cells_;
};

}  // namespace carom::scene
