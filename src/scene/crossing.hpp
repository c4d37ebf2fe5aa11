// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <carom/collision/expects.hpp>
#include <carom/collision/precision.hpp>
#include <carom/scene/arc.hpp>

namespace carom::scene {

/// Bounds of the time of an event. Both are `never` if the event never happens.
struct TimeBounds {
  double earliest = never;
  double latest = never;
};

/// c₀ + c₁ s + c₂ s². The true coefficients differ from c_k by at most e_k.
struct UncertainQuadratic {
  double c0, c1, c2;
  double e0, e1, e2;
};

enum class Decision { none, bounded, undecided };

/// The least s ≥ 0 at which a polynomial falls below 0, for a polynomial that is at least 0 at s = 0. If the decision
/// is `bounded`, the exact crossing differs from s by at most `error`. If the decision is `none`, the polynomial never
/// falls below 0.
struct Crossing {
  Decision decision = Decision::none;
  double s = 0;
  double error = 0;
};

/// Unit roundoff of binary64, the type of the stored state.
inline constexpr double roundoff = unit_roundoff(Precision::binary64);

/// The first crossing of a quadratic, with a bound of its error. Precondition: c₀ ≥ −e₀.
///
/// Let q(s) = c₂ (s − s₁)(s − s₂) be the true quadratic, s₁ its crossing, and D = c₁² − 4 c₀ c₂. The vertex of q is at
/// the distance √D/(2|c₂|) from both roots. If |q(s)| |c₂| < D/4, the computed s lies on the same side of the vertex as
/// s₁. Then |s − s₂| ≥ √D/(2|c₂|), so |s − s₁| ≤ 2 |q(s)|/√D. The computed q(s), its rounding error and the errors e_k
/// bound |q(s)|. If D may be 0 or |q(s)| is too large, the crossing is undecided.
[[nodiscard]] inline Crossing first_crossing(const UncertainQuadratic& q) {
  CAROM_EXPECTS(!(q.c0 < -q.e0), q.c0, q.e0);
  const double square = q.c1 * q.c1;
  const double product = 4 * q.c0 * q.c2;
  const double discriminant = square - product;
  const double size0 = std::abs(q.c0);
  const double size1 = std::abs(q.c1);
  const double size2 = std::abs(q.c2);
  const double e_discriminant = (2 * size1 + q.e1) * q.e1 + 4 * ((size0 + q.e0) * q.e2 + size2 * q.e0) +
                                8 * roundoff * (square + std::abs(product));
  const bool falls = q.c1 < -q.e1;
  if (!falls) {
    // A quadratic that does not fall at s = 0 falls below 0 only if it bends downwards.
    const bool rises = q.c1 > q.e1 || (q.c1 == 0 && q.e1 == 0 && q.c0 > q.e0);
    if (q.c2 > q.e2 || (q.c2 == 0 && q.e2 == 0)) {
      if (rises || discriminant < -e_discriminant || (q.c1 >= 0 && q.e1 == 0)) {
        return {};
      }
      return {Decision::undecided};
    }
    if (!rises || q.c2 >= -q.e2) {
      return {Decision::undecided};
    }
  } else if (discriminant < -e_discriminant) {
    return {};
  }
  const double least_discriminant = discriminant - e_discriminant;
  if (!(least_discriminant > 0)) {
    return {Decision::undecided};
  }
  const double root = std::sqrt(discriminant);
  const double s = falls ? 2 * q.c0 / (root - q.c1) : (q.c1 + root) / (-2 * q.c2);
  const double size = std::abs(s);
  const double terms = (size2 * size + size1) * size + size0;
  const double residual =
      std::abs((q.c2 * s + q.c1) * s + q.c0) + (q.e2 * size + q.e1) * size + q.e0 + 8 * roundoff * terms;
  if (!(8 * residual * (size2 + q.e2) <= least_discriminant)) {
    return {Decision::undecided};
  }
  // The factor 1 + 16 u (u = `roundoff`) covers the roundings of the quotient and the square root.
  return {Decision::bounded, s, (1 + 16 * roundoff) * 2 * residual / std::sqrt(least_discriminant)};
}

/// Bounds of the time `now` + s of the crossing.
[[nodiscard]] inline TimeBounds bounds_from(double now, const Crossing& crossing) {
  const double time = now + crossing.s;
  const double error = (crossing.error + 2 * roundoff * (std::abs(now) + std::abs(crossing.s))) * (1 + 8 * roundoff);
  return {std::max(now, time - error), std::max(now, time + error)};
}

}  // namespace carom::scene
