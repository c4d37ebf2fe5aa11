// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/oracles/exact/rational.hpp>

namespace carom::oracles {

/// The coefficients of a polynomial over ℚ, that of x⁰ first; at least one.
using Coefficients = std::vector<Rational>;

/// The distinct roots x > 0 of `polynomial` with side(x) > 0, in ascending order, each to within 2^−bits of itself.
/// They are isolated and counted exactly, by CGAL's algebraic kernel. Preconditions: `polynomial` is not zero; bits >
/// 0.
[[nodiscard]] std::vector<Rational> positive_roots(const Coefficients& polynomial, const Coefficients& side, int bits);

}  // namespace carom::oracles
