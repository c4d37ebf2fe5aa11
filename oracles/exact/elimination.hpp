// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/laws/truth.hpp>

namespace carom::oracles {

/// The law's answer to a contact that collides, from the defining equations as one linear system in ℚ. Tests compare
/// this slow function with `colliding_truth` (models.hpp), which shares no formula with it. Preconditions: a body is
/// movable; the law is one of `laws_with_truth`. Throws std::invalid_argument for `rough`.
[[nodiscard]] Truth<Rational> truth_by_elimination(const BasicCollision<Rational>& collision, Law law);

}  // namespace carom::oracles
