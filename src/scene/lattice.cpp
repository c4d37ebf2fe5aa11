// SPDX-License-Identifier: BSL-1.0
#include <random>
#include <string>

#include <carom/scene/lattice.hpp>

namespace carom::scene {
namespace {

/// An approximately normal number with mean 0 and standard deviation 1.
double draw(std::mt19937_64& engine) {
  constexpr std::int64_t one = std::int64_t{1} << 53;
  std::int64_t sum = 6 - 6 * one;  // minus the mean of a sum of twelve integers from 0 to one − 1
  for (int i = 0; i < 12; ++i) {
    sum += static_cast<std::int64_t>(engine() >> 11);
  }
  return static_cast<double>(sum) / static_cast<double>(one);
}

}  // namespace

std::vector<Sphere> spheres_of(const Lattice& lattice) {
  const auto& [columns, rows, layers] = lattice.count;
  const std::size_t total = columns * rows * layers;
  std::vector<Sphere> spheres(total, lattice.sphere);
  std::mt19937_64 engine(lattice.seed);
  Vector3<double> sum{0, 0, 0};
  for (std::size_t i = 0; i < total; ++i) {
    Sphere& sphere = spheres[i];
    const std::size_t row = i / columns;
    const std::size_t layer = row / rows;
    const Vector3<double> steps{static_cast<double>(i % columns), static_cast<double>(row % rows),
                                static_cast<double>(layer)};
    sphere.name += ' ' + std::to_string(i);
    sphere.position = lattice.first + lattice.spacing.cwiseProduct(steps);
    for (int axis = 0; axis < 3 && lattice.speed != 0; ++axis) {
      sphere.velocity[axis] = lattice.speed * draw(engine);
    }
    sum += sphere.velocity;
  }
  if (lattice.at_rest_as_a_whole) {
    for (Sphere& sphere : spheres) {
      sphere.velocity -= sum / static_cast<double>(total);
    }
  }
  return spheres;
}

}  // namespace carom::scene
