// SPDX-License-Identifier: BSL-1.0
#include "scene/scene_stepper.hpp"

#include <cmath>
#include <exception>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <carom/report/results/version.hpp>
#include <carom/scene/sphere_simulation.hpp>
#include <carom/scene/valid_scene.hpp>

namespace carom::tool {
namespace {

/// The greatest relative difference between a moment and 2/5 m R², so that the body is a uniform ball: two roundings of
/// the product, and one of the caller.
constexpr double rounding_of_moment = 4 * 0x1p-53;

/// Why the simulation cannot pose the body. Empty if it can.
std::string why_not(const SteppedBody& body) {
  if (std::holds_alternative<HalfSpaceShape>(body.shape)) {
    return {};
  }
  const auto* const sphere = std::get_if<SphereShape>(&body.shape);
  if (sphere == nullptr || body.is_fixed) {
    return "only movable spheres and fixed half-spaces are simulated in steps";
  }
  const double moment = 0.4 * body.mass * sphere->radius * sphere->radius;
  const bool is_uniform = ((body.principal_inertia.array() - moment).abs() <= rounding_of_moment * moment).all();
  return is_uniform ? "" : "only uniform spheres are simulated";
}

scene::Scene scene_of(const SteppedScene& posed) {
  scene::Scene scene;
  scene.law = posed.friction > 0 ? Law::coulomb : Law::frictionless;
  scene.gravity = posed.gravity;
  scene.materials = {"all"};
  scene.pairs = scene::MaterialPairs(1);
  scene.pairs.set(0, 0, {posed.restitution, posed.friction});
  for (const SteppedBody& body : posed.bodies) {
    const std::string name = std::to_string(scene.spheres.size() + scene.planes.size());
    if (const auto* const sphere = std::get_if<SphereShape>(&body.shape)) {
      const double volume = 4 * std::numbers::pi / 3 * sphere->radius * sphere->radius * sphere->radius;
      scene.spheres.push_back({name, sphere->radius, body.mass / volume, 0, body.state.position, body.state.velocity,
                               body.state.angular_velocity});
    } else {
      scene.planes.push_back({name, 0, std::get<HalfSpaceShape>(body.shape).normal, body.state.position});
    }
  }
  scene::move_apart(scene);
  return scene;
}

std::vector<scene::Arc> arcs_of(const scene::SphereSimulation& simulation) {
  std::vector<scene::Arc> arcs;
  for (std::size_t sphere = 0; sphere < simulation.size(); ++sphere) {
    arcs.push_back(simulation.arc(sphere));
  }
  return arcs;
}

/// The states of the bodies at a time. The simulation knows no orientation of a sphere.
std::vector<BodyState> states_at(double time, const std::vector<scene::Arc>& arcs, const SteppedScene& posed) {
  std::vector<BodyState> states;
  std::size_t sphere = 0;
  for (const SteppedBody& body : posed.bodies) {
    BodyState state = body.state;
    if (!body.is_fixed) {
      const scene::Arc& arc = arcs[sphere++];
      state.position = position_at(arc.path, time);
      state.velocity = velocity_at(arc.path, time);
      state.angular_velocity = angular_velocity_at(arc, time);
    }
    states.push_back(state);
  }
  return states;
}

/// Throws SceneError if the run cannot go on.
SteppedStates reported_states(const scene::Scene& scene, const Stepping& stepping) {
  scene::SphereSimulation simulation(scene);
  std::vector<scene::Arc> arcs = arcs_of(simulation);  // before the next event
  const scene::Event* event = simulation.advance();
  SteppedStates answer;
  for (const std::uint64_t after : stepping.report) {
    const double time = static_cast<double>(after) * stepping.step;
    while (event != nullptr && event->time <= time) {
      arcs = arcs_of(simulation);
      event = simulation.advance();
    }
    answer.states.push_back(states_at(time, arcs, stepping.scene));
  }
  return answer;
}

SteppingAnswer answer_to(const Stepping& stepping) {
  for (const SteppedBody& body : stepping.scene.bodies) {
    if (std::string why = why_not(body); !why.empty()) {
      return Skipped{std::move(why)};
    }
  }
  scene::Scene scene = scene_of(stepping.scene);
  scene.duration = static_cast<double>(steps_of(stepping)) * stepping.step;
  if (const std::optional<scene::SceneDefect> defect = first_defect(scene)) {
    return Skipped{describe(*defect)};
  }
  try {
    return reported_states(scene, stepping);
  } catch (const scene::SceneError& error) {
    return Skipped{error.what()};
  } catch (const std::exception& fault) {  // the simulation is a subject here, and the other engines' results remain
    return Failed{fault.what()};
  }
}

}  // namespace

Stepper scene_stepper() {
  return {.name = "scene", .version = report::version, .cannot = {"box"}, .open = [] { return answer_to; }};
}

}  // namespace carom::tool
