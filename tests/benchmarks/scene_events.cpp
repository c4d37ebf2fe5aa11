// SPDX-License-Identifier: BSL-1.0
// Events per second of a gas of elastic spheres, by the number of spheres: scene_events [EVENTS [VOLUME_FRACTION
// [CSV]]]. Each round has EVENTS events. tests/figures/figures.py draws the file CSV.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include <carom/scene/lattice.hpp>
#include <carom/scene/sphere_simulation.hpp>

namespace {

using carom::scene::Scene;

constexpr double radius = 0.5;  // [m]
constexpr std::array edges{5, 8, 10, 15, 22, 32, 47};
constexpr std::size_t rounds = 7;

Scene gas(int edge, double volume_fraction) {
  Scene scene;
  scene.materials = {"gas"};
  scene.pairs = carom::scene::MaterialPairs(1);
  scene.duration = 1e9;
  const double spacing = std::cbrt(4.0 / 3.0 * std::numbers::pi * radius * radius * radius / volume_fraction);
  carom::scene::Lattice lattice;
  const auto count = static_cast<std::size_t>(edge);
  lattice.count = {count, count, count};
  lattice.spacing = carom::Vector3<double>::Constant(spacing);
  lattice.first = carom::Vector3<double>::Constant(spacing / 2);
  lattice.sphere.radius = radius;
  lattice.speed = 1;
  lattice.seed = 1;
  scene.spheres = spheres_of(lattice);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      carom::scene::Plane plane;
      plane.normal.setZero();
      plane.normal[axis] = side;
      plane.point.setZero();
      plane.point[axis] = side > 0 ? 0 : edge * spacing;
      scene.planes.push_back(plane);
    }
  }
  return scene;
}

/// The processor time of `events` events [s].
double seconds_of(carom::scene::SphereSimulation& simulation, long events) {
  const std::clock_t begin = std::clock();
  for (long k = 0; k < events; ++k) {
    if (simulation.advance() == nullptr) {
      break;
    }
  }
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

struct Measured {
  std::unique_ptr<carom::scene::SphereSimulation> simulation;
  std::vector<double> rates;  // events per second in each round; ascending at the end
  double cells_left = 0;      // crossings of cells per event
};

/// Each round runs all sizes in turn, so a disturbance of the machine affects all sizes.
std::vector<Measured> measure(long events, double volume_fraction) {
  std::vector<Measured> all;
  for (const int edge : edges) {
    all.push_back({std::make_unique<carom::scene::SphereSimulation>(gas(edge, volume_fraction)), {}});
    // During these events, the spheres leave the initial lattice.
    seconds_of(*all.back().simulation, std::max(events, 2 * static_cast<long>(all.back().simulation->size())));
  }
  for (std::size_t round = 0; round < rounds; ++round) {
    for (Measured& one : all) {
      const auto crossings = one.simulation->counts().crossings;
      one.rates.push_back(static_cast<double>(events) / seconds_of(*one.simulation, events));
      one.cells_left =
          static_cast<double>(one.simulation->counts().crossings - crossings) / static_cast<double>(events);
    }
  }
  for (Measured& one : all) {
    std::sort(one.rates.begin(), one.rates.end());
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  const long events = argc > 1 ? std::atol(argv[1]) : 100'000;
  const double volume_fraction = argc > 2 ? std::atof(argv[2]) : 0.2;
  const std::vector<Measured> all = measure(events, volume_fraction);
  fmt::print("volume fraction {}, {} rounds of {} events, one core; events a second of processor time\n",
             volume_fraction, rounds, events);
  fmt::print("{:>8}  {:>9}  {:>9}  {:>9}  {:>15}  {:>16}\n", "spheres", "median", "least", "most", "cells left each",
             "bytes a sphere");
  for (const Measured& one : all) {
    fmt::print("{:>8}  {:>9.0f}  {:>9.0f}  {:>9.0f}  {:>15.2f}  {:>16}\n", one.simulation->size(),
               one.rates[rounds / 2], one.rates.front(), one.rates.back(), one.cells_left,
               one.simulation->bytes_per_sphere());
  }
  if (argc > 3) {
    std::ofstream csv(argv[3]);
    csv << "spheres,median,least,most\n";
    for (const Measured& one : all) {
      csv << fmt::format("{},{:.0f},{:.0f},{:.0f}\n", one.simulation->size(), one.rates[rounds / 2], one.rates.front(),
                         one.rates.back());
    }
    return csv.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
}
