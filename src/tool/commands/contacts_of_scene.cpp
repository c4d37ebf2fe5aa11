// SPDX-License-Identifier: BSL-1.0
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/scene/polyhedra/scene_simulation.hpp>

#include "commands/plan.hpp"
#include "io/usage_error.hpp"
#include "scene/scene_run.hpp"

namespace carom::tool::plan {
namespace {

using properties::plan::ClassedCollision;

std::string class_of(const scene::Scene& scene, const scene::Event& event) {
  const auto material = [&](std::size_t body) { return scene.materials[material_of(scene, body)]; };
  const bool is_of_sphere = is_sphere(scene, event.a.body);
  if (event.b) {
    const bool is_with_sphere = is_sphere(scene, event.b->body);
    const char* const kinds = is_of_sphere && is_with_sphere     ? "spheres"
                              : !is_of_sphere && !is_with_sphere ? "polyhedra"
                                                                 : "sphere and polyhedron";
    return fmt::format("{}: {} and {}", kinds, material(event.a.body), material(event.b->body));
  }
  return fmt::format("{} and plane: {} and {}", is_of_sphere ? "sphere" : "polyhedron", material(event.a.body),
                     scene.materials[scene.planes[event.plane].material]);
}

/// Keeps every `stride_`-th contact. At 2 · most_contacts_of_scene contacts, drops every second one and doubles
/// `stride_`.
class Sampled {
 public:
  void add(ClassedCollision contact) {
    if (seen_++ % stride_ == 0) {
      contacts_.push_back(std::move(contact));
    }
    if (contacts_.size() == 2 * most_contacts_of_scene) {
      for (std::size_t k = 0; k < most_contacts_of_scene; ++k) {
        contacts_[k] = std::move(contacts_[2 * k]);
      }
      contacts_.resize(most_contacts_of_scene);
      stride_ *= 2;
    }
  }
  [[nodiscard]] std::vector<ClassedCollision> take() { return std::move(contacts_); }

 private:
  std::size_t seen_ = 0;
  std::size_t stride_ = 1;
  std::vector<ClassedCollision> contacts_;
};

}  // namespace

RecordedContacts contacts_of_scene(const std::string& text, const std::string& file, const std::stop_token& stop) {
  const scene::Scene scene = scene_of(text, file);
  Sampled contacts;
  try {
    scene::SceneSimulation simulation(scene);
    simulation.stop_on(stop);
    while (const scene::Event* event = simulation.advance()) {
      if (event->has_impulse) {
        contacts.add({class_of(scene, *event), event->collision, fmt::format("{}: t = {} s", file, event->time), true});
      }
    }
    if (stop.stop_requested()) {
      throw UsageError(fmt::format("{}: the user stopped the simulation at t = {} s", file, simulation.time()));
    }
  } catch (const scene::SceneError& error) {
    fmt::print(stderr, "carom: {}: the plan is for the collisions until the simulation ended: {}\n", file,
               error.what());
  }
  RecordedContacts recorded{contacts.take(), scene.law};
  if (recorded.contacts.empty()) {
    throw UsageError(fmt::format("{}: this scene has no collisions; a plan needs at least one", file));
  }
  return recorded;
}

}  // namespace carom::tool::plan
