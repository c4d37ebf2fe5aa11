// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::subjects {

/// Bullet's sequential impulse solver, double build: as shipped and configured.
[[nodiscard]] std::vector<Subject> bullet_subjects();

/// ODE's world step on one contact joint, double build: as shipped and configured.
[[nodiscard]] std::vector<Subject> ode_subjects();

}  // namespace carom::subjects
