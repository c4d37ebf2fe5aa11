// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/oracles/exact/rational.hpp>

namespace carom::oracles {

/// The coefficients of a polynomial over ℚ, from x⁰ up. There is at least one.
using Coefficients = std::vector<Rational>;

/// All distinct roots x > 0 of `polynomial` with side(x) > 0, in ascending order. Each number of the result has a
/// relative error of at most 2^−bits. Preconditions: `polynomial` is not zero; `side` has a coefficient; bits > 0.
[[nodiscard]] std::vector<Rational> positive_roots(const Coefficients& polynomial, const Coefficients& side, int bits);

}  // namespace carom::oracles
