// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <carom/scene/scene.hpp>

namespace carom::scene {

/// Equal spheres in rows, columns and layers, each with a velocity of its own.
struct Lattice {
  std::array<std::size_t, 3> count{1, 1, 1};  // along each axis of the world
  Vector3<double> first{0, 0, 0};             // centre of the sphere that all others are counted from [m]
  Vector3<double> spacing{1, 1, 1};           // from one centre to the next along each axis [m]
  Sphere sphere;                              // what all have alike: radius, density, material; its name begins theirs
  double speed = 0;                           // standard deviation of each component of each velocity [m/s]
  std::uint64_t seed = 0;
  bool at_rest_as_a_whole = false;  // the mean velocity is taken off, but for rounding
};

/// The spheres, x counted first, then y, then z, named "NAME k" from 0 on. The same bits on every machine, without
/// contraction: from std::mt19937_64, each component is the sum of 12 uniform numbers less its mean, which has the
/// deviation 1 and is normal up to about three of it (Irwin–Hall; none is beyond 6).
[[nodiscard]] std::vector<Sphere> spheres_of(const Lattice& lattice);

}  // namespace carom::scene
