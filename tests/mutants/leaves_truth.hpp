// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/judge/exact_case.hpp>

#include "damage.hpp"

namespace carom::mutants {

/// The collision as solvers in binary64 read it: the lever arms are rounded once, and the contact is at the origin.
[[nodiscard]] Collision as_read(const Collision& collision);

/// Whether the damage leaves the exact outcome of a colliding contact unchanged. If so, no judge can find the damage.
/// `read` is the result of `as_read`.
[[nodiscard]] bool leaves_truth(Damage damage, const oracles::ExactCase& read, Law law);

}  // namespace carom::mutants
