// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/laws/truth.hpp>

namespace carom::oracles {

/// The law's answer to a contact that collides, the long way: the defining equations as one linear system in the 15
/// unknowns v_A⁺, w_A⁺, v_B⁺, w_B⁺, F, solved by elimination in ℚ. Slow; it checks `colliding_truth`, with which it
/// shares no formula (the inertia tensor is R diag(I) Rᵀ, with R written out). Preconditions: a body is movable; the
/// law is one of `laws_with_truth`, and not `rough`, which combines the answers of two others and throws
/// std::invalid_argument.
[[nodiscard]] Truth<Rational> truth_by_elimination(const BasicCollision<Rational>& collision, Law law);

}  // namespace carom::oracles
