// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/laws/truth.hpp>

namespace carom::oracles {

/// The law's answer to a contact that collides, from the defining equations as one linear system in the 15 unknowns
/// v_A⁺, w_A⁺, v_B⁺, w_B⁺ and F. Elimination in ℚ solves the system. It is slow and serves to check `colliding_truth`.
/// The two share no formula: here the inertia tensor is R diag(I) Rᵀ, with R written out. Preconditions: a body is
/// movable; the law is one of `laws_with_truth`. Throws std::invalid_argument for `rough`, which combines the
/// answers of two other laws.
[[nodiscard]] Truth<Rational> truth_by_elimination(const BasicCollision<Rational>& collision, Law law);

}  // namespace carom::oracles
