// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/laws/truth.hpp>

namespace carom::oracles {

/// The law's answer to a contact that collides, from the defining equations as one linear system in the 15 unknowns
/// v_A⁺, w_A⁺, v_B⁺, w_B⁺ and F. Elimination in ℚ solves the system. The function is slow, and tests compare
/// `colliding_truth` (models.hpp) with it. The two functions share no formula. For example, the inertia tensor here is
/// R diag(I) Rᵀ, with the rotation R written out. Preconditions: a body is movable; the law is one of
/// `laws_with_truth`. Throws std::invalid_argument for `rough`, which combines the answers of two other laws.
[[nodiscard]] Truth<Rational> truth_by_elimination(const BasicCollision<Rational>& collision, Law law);

}  // namespace carom::oracles
