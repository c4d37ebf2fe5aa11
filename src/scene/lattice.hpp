// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <carom/scene/scene.hpp>

namespace carom::scene {

/// Equal spheres in rows, columns and layers, each with its own velocity.
struct Lattice {
  std::array<std::size_t, 3> count{1, 1, 1};  // along each axis of the world
  Vector3<double> first{0, 0, 0};             // centre of the first sphere [m]
  Vector3<double> spacing{1, 1, 1};           // from one centre to the next along each axis [m]
  Sphere sphere;     // radius, density and material of every sphere, and the beginning of its name
  double speed = 0;  // standard deviation of each component of each velocity [m/s]
  std::uint64_t seed = 0;
  bool at_rest_as_a_whole = false;  // whether the mean velocity is subtracted from each velocity
};

/// The spheres in order of x, then y, then z, named "NAME k" from k = 0 on. Every machine gives the same bits if the
/// code is compiled without fused multiply-adds. Each velocity component is `speed` times a random number with mean 0:
/// the sum of 12 uniform numbers of std::mt19937_64, minus 6. The distribution (Irwin–Hall) is nearly normal up to 3
/// standard deviations, and ends at 6.
[[nodiscard]] std::vector<Sphere> spheres_of(const Lattice& lattice);

}  // namespace carom::scene
