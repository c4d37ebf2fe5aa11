// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/judge/exact_case.hpp>

#include "damage.hpp"

namespace carom::mutants {

/// The collision as solvers in binary64 read it: with lever arms that are rounded once, and the contact at the origin.
[[nodiscard]] Collision as_read(const Collision& collision);

/// Whether the damage, done to the exact outcome of a law where the contact collides, leaves it as it is: then no judge
/// can see it that grants a solver the rounding of its lever arms. Of a collision as it is read.
[[nodiscard]] bool leaves_truth(Damage damage, const oracles::ExactCase& read, Model model);

}  // namespace carom::mutants
