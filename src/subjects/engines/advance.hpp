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

/// Advances a `World(stepping, configured)`, and reports its states. It has `step()` and `state(body)` of a movable
/// body. The clock runs only while the world steps. Ten steps of another world come before it, so that caches are warm.
template <class World>
[[nodiscard]] SteppingAnswer advanced(const Stepping& stepping, bool configured) try {
  using Clock = std::chrono::steady_clock;
  constexpr int warming_steps = 10;
  {
    World warming(stepping, configured);
    for (int i = 0; i < warming_steps; ++i) {
      warming.step();
    }
  }
  World world(stepping, configured);
  SteppedStates answer;
  std::uint64_t done = 0;
  for (const std::uint64_t after : stepping.report) {
    const Clock::time_point start = Clock::now();
    for (; done < after; ++done) {
      world.step();
    }
    answer.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    std::vector<BodyState>& states = answer.states.emplace_back();
    for (std::size_t body = 0; body < stepping.scene.bodies.size(); ++body) {
      const SteppedBody& posed = stepping.scene.bodies[body];
      states.push_back(posed.is_fixed ? posed.state : world.state(body));
    }
  }
  return answer;
} catch (const std::exception& failure) {
  return Failed{failure.what()};
}

/// An engine with these facts, configured and as shipped.
template <class World>
[[nodiscard]] std::vector<Stepper> both_settings(const Stepper& facts) {
  std::vector<Stepper> both{facts, facts};
  both[1].name += "-as-shipped";
  both[0].open = [] { return [](const Stepping& stepping) { return advanced<World>(stepping, true); }; };
  both[1].open = [] { return [](const Stepping& stepping) { return advanced<World>(stepping, false); }; };
  return both;
}

}  // namespace carom::subjects
