// SPDX-License-Identifier: GPL-3.0-or-later
// Events a second of a gas of elastic spheres, by the number of spheres: scene_events [EVENTS [VOLUME_FRACTION]].
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include <carom/scene/lattice.hpp>
#include <carom/scene/simulation.hpp>

namespace {

using carom::scene::Scene;

constexpr double radius = 0.5;  // [m]

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

double seconds_of(carom::scene::Simulation& simulation, long events) {
  const auto begin = std::chrono::steady_clock::now();
  for (long k = 0; k < events; ++k) {
    if (simulation.advance() == nullptr) {
      break;
    }
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main(int argc, char** argv) {
  const long events = argc > 1 ? std::atol(argv[1]) : 300'000;
  const double volume_fraction = argc > 2 ? std::atof(argv[2]) : 0.2;
  fmt::print("volume fraction {}, {} events after as many to begin with, one core\n", volume_fraction, events);
  fmt::print("{:>8}  {:>12}  {:>10}  {:>15}  {:>16}\n", "spheres", "events a s", "ns each", "cells left each",
             "bytes a sphere");
  for (const int edge : {5, 10, 22, 47}) {
    carom::scene::Simulation simulation(gas(edge, volume_fraction));
    seconds_of(simulation, events);
    const auto crossings = simulation.counts().crossings;
    const double seconds = seconds_of(simulation, events);
    fmt::print("{:>8}  {:>12.0f}  {:>10.0f}  {:>15.2f}  {:>16}\n", simulation.size(),
               static_cast<double>(events) / seconds, 1e9 * seconds / static_cast<double>(events),
               static_cast<double>(simulation.counts().crossings - crossings) / static_cast<double>(events),
               simulation.bytes_per_sphere());
  }
}
