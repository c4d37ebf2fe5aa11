// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <vector>

#include <carom/collision/stepper.hpp>
#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/steppers.hpp>

namespace carom::subjects {

/// Calls `sphere` with the radius, `box` with the half lengths, or `half_space` with the unit normal.
template <class Sphere, class Box, class HalfSpace>
auto with_shape(const Shape& shape, Sphere sphere, Box box, HalfSpace half_space) {
  if (const auto* const one = std::get_if<SphereShape>(&shape)) {
    return sphere(one->radius);
  }
  const auto* const one = std::get_if<BoxShape>(&shape);
  return one != nullptr ? box(Vector3<double>(one->lengths / 2))
                        : half_space(unit(std::get<HalfSpaceShape>(shape).normal));
}

/// Fills a `World(stepping, configured)` by `add(body)`, advances it by `step()`, and reports each `state(body)` of a
/// movable body. The clock runs only while the world steps.
template <class World>
[[nodiscard]] SteppedStates advanced(const Stepping& stepping, bool configured) {
  using Clock = std::chrono::steady_clock;
  const std::vector<SteppedBody>& bodies = stepping.scene.bodies;
  World world(stepping, configured);
  for (const SteppedBody& body : bodies) {
    world.add(body);
  }
  SteppedStates answer;
  std::uint64_t done = 0;
  for (const std::uint64_t after : stepping.report) {
    const Clock::time_point start = Clock::now();
    for (; done < after; ++done) {
      world.step();
    }
    answer.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    std::vector<BodyState>& states = answer.states.emplace_back();
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      states.push_back(bodies[body].is_fixed ? bodies[body].state : world.state(body));
    }
  }
  return answer;
}

/// Ten steps of another world come before the world that counts, so that caches are warm.
template <class World>
[[nodiscard]] SteppingAnswer answer(const Stepping& stepping, bool configured) try {
  Stepping warming = stepping;
  warming.report = {10};
  static_cast<void>(advanced<World>(warming, configured));
  return advanced<World>(stepping, configured);
} catch (const std::exception& failure) {
  return Failed{failure.what()};
}

/// An engine with these facts, configured and as shipped.
template <class World>
[[nodiscard]] std::vector<Stepper> both_settings(const Stepper& facts) {
  std::vector<Stepper> both{facts, facts};
  both[1].name += "-as-shipped";
  both[0].open = [] { return [](const Stepping& stepping) { return answer<World>(stepping, true); }; };
  both[1].open = [] { return [](const Stepping& stepping) { return answer<World>(stepping, false); }; };
  return both;
}

}  // namespace carom::subjects
