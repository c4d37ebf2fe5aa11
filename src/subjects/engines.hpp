// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/subjects/protocol/exec.hpp>

namespace carom::subjects {

/// The double build of Bullet's sequential impulse solver, as shipped and configured.
[[nodiscard]] std::vector<Subject> bullet_subjects();

/// The double build of ODE's world step on one contact joint, as shipped and configured.
[[nodiscard]] std::vector<Subject> ode_subjects();

/// The engines that run in programs of their own and speak the protocol. They have a `specification`, and no `open`
/// until `started` sets it.
[[nodiscard]] std::vector<Subject> protocol_engines();

/// The same subject, ready to be opened. If its program is installed, it is started and asked to introduce itself.
[[nodiscard]] Subject started(const Subject& subject, const protocol::ExecOptions& options);

}  // namespace carom::subjects
