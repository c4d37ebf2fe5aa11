// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stop_token>
#include <utility>
#include <variant>

#include <carom/scene/polyhedra/polyhedron_simulation.hpp>
#include <carom/scene/sphere_simulation.hpp>

namespace carom::scene {

/// The simulation of a scene: SphereSimulation if it has only spheres, otherwise PolyhedronSimulation.
class SceneSimulation {
 public:
  explicit SceneSimulation(Scene scene) : loop_(made_for(std::move(scene))) {}

  [[nodiscard]] const Event* advance() {
    return std::visit([](auto& loop) { return loop.advance(); }, loop_);
  }
  void stop_on(std::stop_token stop) {
    std::visit([&](auto& loop) { loop.stop_on(std::move(stop)); }, loop_);
  }
  [[nodiscard]] const Scene& scene() const {
    return std::visit([](const auto& loop) -> const Scene& { return loop.scene(); }, loop_);
  }
  [[nodiscard]] double time() const {
    return std::visit([](const auto& loop) { return loop.time(); }, loop_);
  }
  [[nodiscard]] const Counts& counts() const {
    return std::visit([](const auto& loop) -> const Counts& { return loop.counts(); }, loop_);
  }
  [[nodiscard]] std::size_t size() const {
    return std::visit([](const auto& loop) { return loop.size(); }, loop_);
  }
  [[nodiscard]] SceneState state() const {
    return std::visit([](const auto& loop) { return loop.state(); }, loop_);
  }

 private:
  using Loop = std::variant<SphereSimulation, PolyhedronSimulation>;

  [[nodiscard]] static Loop made_for(Scene scene) {
    if (scene.polyhedra.empty()) {
      return Loop(std::in_place_type<SphereSimulation>, std::move(scene));
    }
    return Loop(std::in_place_type<PolyhedronSimulation>, std::move(scene));
  }

  Loop loop_;
};

}  // namespace carom::scene
