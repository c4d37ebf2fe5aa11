// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/subjects/protocol/exec.hpp>

namespace carom::subjects {

/// Bullet's sequential impulse solver, double build: as shipped and configured.
[[nodiscard]] std::vector<Subject> bullet_subjects();

/// ODE's world step on one contact joint, double build: as shipped and configured.
[[nodiscard]] std::vector<Subject> ode_subjects();

/// The engines that speak the protocol, in programs of their own: with `specification`, and without `open` until
/// started.
[[nodiscard]] std::vector<Subject> protocol_engines();

/// The same subject, ready to be opened: a program that is installed is started and asked what it is.
[[nodiscard]] Subject started(const Subject& subject, const protocol::ExecOptions& options);

}  // namespace carom::subjects
