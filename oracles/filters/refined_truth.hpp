// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/oracles/laws/branch.hpp>
#include <carom/oracles/laws/truth.hpp>
#include <carom/oracles/models/superposition.hpp>
#include <carom/oracles/numbers/approximation.hpp>
#include <carom/oracles/numbers/enclosure.hpp>

namespace carom::oracles {

[[nodiscard]] Approximation approximation_of(const Enclosure& x);

[[nodiscard]] Enclosure enclosure_of(const Approximation& x);

struct ApproximateResponse {
  explicit ApproximateResponse(const BasicCollision<Approximation>& collision);

  /// The changes of all velocities by this impulse, by superposition.
  [[nodiscard]] Outcome<Approximation> operator()(const Vector3<Approximation>& impulse) const;

  std::array<Outcome<Approximation>, 3> units;
  Matrix3<Approximation> matrix;
};

/// The law's answer to a contact that collides, to about 100 bits, at a fraction of the cost of `colliding_truth` in
/// enclosures. The method is one step of iterative refinement (J. Wilkinson) with bounds. The law requires a change ΔV
/// of relative velocity. A first impulse F̂, computed in binary64, leaves the change ΔV − K F̂ to a second impulse. If
/// the law permits F̂, the exact F is the sum of the two impulses, so F̂ needs no bound. The second impulse is smaller
/// by the precision of binary64, so approximations suffice for it. Preconditions: a body is movable; the law is one of
/// `laws_with_truth`.
[[nodiscard]] Truth<Enclosure> refined_truth(const Collision& collision, const BasicCollision<Enclosure>& enclosed,
                                             const BasicCollision<Approximation>& approximate, Law law, Branch branch,
                                             const ApproximateResponse& approximate_response);

/// Whether every number of the outcome has a finite bound.
[[nodiscard]] bool is_bounded(const Truth<Enclosure>& truth);

}  // namespace carom::oracles
