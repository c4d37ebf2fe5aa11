// SPDX-License-Identifier: BSL-1.0
// A ball 1 m above a floor falls for √(2 h / g) seconds.
#include <cmath>

#include <carom/scene/sphere_simulation.hpp>

int main() {
  carom::scene::Scene scene;
  scene.materials = {"rubber"};
  scene.pairs = carom::scene::MaterialPairs(1);
  scene.gravity = {0, 0, -9.81};
  scene.duration = 10;
  carom::scene::Plane floor;
  floor.normal = {0, 0, 1};
  floor.point = {0, 0, 0};
  scene.planes = {floor};
  carom::scene::Sphere ball;
  ball.radius = 0.5;
  ball.position = {0, 0, 1.5};
  scene.spheres = {ball};
  carom::scene::SphereSimulation simulation(scene);
  const carom::scene::Event* const first = simulation.advance();
  return first != nullptr && std::abs(first->time - std::sqrt(2 / 9.81)) < 1e-12 ? 0 : 1;
}
