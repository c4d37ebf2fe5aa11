// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/oracles/laws/branch.hpp>
#include <carom/oracles/laws/truth.hpp>
#include <carom/oracles/models/superposition.hpp>
#include <carom/oracles/numbers/approximation.hpp>
#include <carom/oracles/numbers/enclosure.hpp>

namespace carom::oracles {

/// The number as an approximation, with what it is not known to.
[[nodiscard]] Approximation approximation_of(const Enclosure& x);

[[nodiscard]] Enclosure enclosure_of(const Approximation& x);

/// How a collision answers to impulses, approximately.
struct ApproximateResponse {
  explicit ApproximateResponse(const BasicCollision<Approximation>& collision);

  /// The change of all velocities, by superposition.
  [[nodiscard]] Outcome<Approximation> operator()(const Vector3<Approximation>& impulse) const;

  std::array<Outcome<Approximation>, 3> units;
  Matrix3<Approximation> matrix;
};

/// The law's answer to a contact that collides, to about 100 bits, at a small part of the cost: one step of iterative
/// refinement (J. Wilkinson), with bounds. Any impulse F̂ that the law permits leaves the change ΔV − K F̂ to be made up
/// for; F is F̂ and the impulse for that, exactly, so that F̂ needs no bound, and the second impulse, smaller by the
/// precision of binary64, no more than that of approximations. Preconditions: as of impulse_for.
[[nodiscard]] Truth<Enclosure> refined_truth(const Collision& collision, const BasicCollision<Enclosure>& enclosed,
                                             const BasicCollision<Approximation>& approximate, Law law, Branch branch,
                                             const ApproximateResponse& approximate_response);

/// Whether every number has a bound.
[[nodiscard]] bool is_bounded(const Truth<Enclosure>& truth);

}  // namespace carom::oracles
