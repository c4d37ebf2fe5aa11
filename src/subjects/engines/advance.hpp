// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

#include <carom/collision/stepper.hpp>

namespace carom::subjects {

/// Advances the world that `make` makes, and reports its states. A world has `step()` and `state(body)` of a movable
/// body. The clock runs only while the world steps. Ten steps of another world come before it, so that caches are warm.
template <class Make>
[[nodiscard]] SteppedStates advanced(const Stepping& stepping, const Make& make) {
  using Clock = std::chrono::steady_clock;
  constexpr int warming_steps = 10;
  {
    auto warming = make();
    for (int i = 0; i < warming_steps; ++i) {
      warming.step();
    }
  }
  auto world = make();
  SteppedStates answer;
  std::uint64_t done = 0;
  for (const std::uint64_t after : stepping.report) {
    const Clock::time_point start = Clock::now();
    for (; done < after; ++done) {
      world.step();
    }
    answer.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    std::vector<BodyState> states;
    for (std::size_t body = 0; body < stepping.scene.bodies.size(); ++body) {
      const SteppedBody& posed = stepping.scene.bodies[body];
      states.push_back(posed.is_fixed ? posed.state : world.state(body));
    }
    answer.states.push_back(std::move(states));
  }
  return answer;
}

/// An engine with these facts, configured and as shipped.
[[nodiscard]] inline std::vector<Stepper> both_settings(const Stepper& facts,
                                                        SteppingAnswer (*run)(const Stepping&, bool configured)) {
  std::vector<Stepper> both{facts, facts};
  both[1].name += "-as-shipped";
  both[0].open = [run] { return [run](const Stepping& stepping) { return run(stepping, true); }; };
  both[1].open = [run] { return [run](const Stepping& stepping) { return run(stepping, false); }; };
  return both;
}

}  // namespace carom::subjects
