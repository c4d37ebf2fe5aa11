// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/subjects/protocol/exec.hpp>

namespace carom::subjects {

/// Bullet's sequential impulse solver in double, as shipped and configured.
[[nodiscard]] std::vector<Subject> bullet_subjects();

/// ODE's world step on one contact joint in double, as shipped and configured.
[[nodiscard]] std::vector<Subject> ode_subjects();

/// The engines that run in programs of their own and speak the protocol. They have no `open` until `started` sets it.
[[nodiscard]] std::vector<Subject> protocol_engines();

/// The subject with its `open` set. Starts the program of an installed engine, which then introduces itself.
[[nodiscard]] Subject started(const Subject& subject, const protocol::ExecOptions& options);

/// The folder of this program; empty if the system does not provide it.
[[nodiscard]] std::filesystem::path program_directory();

}  // namespace carom::subjects
