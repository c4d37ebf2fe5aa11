// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/stepper.hpp>
#include <carom/subjects/protocol/exec.hpp>

namespace carom::subjects {

/// The engines that are linked, each configured and as shipped. Only builds with the engine define its function.
[[nodiscard]] std::vector<Stepper> bullet_steppers();
[[nodiscard]] std::vector<Stepper> ode_steppers();
[[nodiscard]] std::vector<Stepper> box2d_steppers();

/// The engines of npm, which the adapters in engines/npm/time run.
[[nodiscard]] std::vector<Stepper> npm_steppers();

/// All engines in time, each configured and as shipped. An engine that is not installed is absent.
[[nodiscard]] std::vector<Stepper> all_steppers();

/// The engine with its `open` set. Starts the program of an installed engine, which then introduces itself.
[[nodiscard]] Stepper started(const Stepper& stepper, const protocol::ExecOptions& options);

}  // namespace carom::subjects
