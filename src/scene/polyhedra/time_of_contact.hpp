// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/scene/polyhedra/distance.hpp>
#include <carom/scene/polyhedra/motion.hpp>

namespace carom::scene {

enum class Approach {
  touches,    // within the tolerance at the time given, and not before
  misses,     // certain to stay apart up to the horizon
  overlaps,   // not certain to be apart when it begins
  undecided,  // certain to be apart up to the time given; the tolerance is finer than the numbers can tell, or it takes
              // too long
};

struct TimeOfContact {
  Approach approach = Approach::misses;
  double time = 0;        // [s]
  Separation separation;  // at that time
  int advances = 0;       // how many separations it took
};

/// The first time in [begin, horizon] at which two moving shapes are within the tolerance [m] of each other and do not
/// draw apart. Up to that time, and at it, they are certain not to touch, whatever is rounded: the motion is the exact
/// one from the numbers given, and its errors are taken off every gap.
///
/// Conservative advancement (B. Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996): from a
/// certified separation along n, time goes on as far as the gap along n is certain to stay open; then a new n is found.
/// Mirtich's step is gap / (greatest speed of any point), of first order; here every vertex has its own velocity along
/// n and only what velocities change by is bounded, so the steps are of second order:
///
///     n·(x_v(s+Δ) − y_u(s+Δ)) ≥ n·(x_v − y_u) + Δ n·(ẋ_v − ẏ_u) + ½ Δ² n·(a_A − a_B) − ½ Δ² (C_A + C_B),
///     C = r ω² (1 + a/√3),
///
/// with r the greatest distance of a vertex from its centre, ω the greatest rate of the whole motion and a ω²/√3 ≥ ‖ω'‖
/// (RotationPath). The same is tried for an n that turns at a constant rate Ω: that of A or of B, so that a face of the
/// turning body stays a face, or the one that keeps n across an edge of each. In axes that turn with n the velocity of
/// a point x from B's centre is ẋ − Ω × x, and the second derivative has C_A + C_B + ‖a_A − a_B‖ + 2 ‖Ω‖ ‖ẋ‖ + ‖Ω‖²
/// ‖x‖ in place of what stands above. The longest step is taken; the shapes draw apart where one of these n says so.
///
/// A gap within the tolerance at the beginning, as after an impact, is no contact as long as the shapes draw apart; it
/// becomes one where they do no longer; bodies that do not move against each other meet never. Preconditions: both
/// motions start by `begin` and end no sooner than the horizon; the tolerance is positive, and is met in full only
/// where it is above about 2⁻⁴⁴ of sizes and distance and of the errors of placements: below, the answer is
/// `undecided`, at the last time up to which they are certain to be apart.
[[nodiscard]] TimeOfContact time_of_contact(const ShapePair& pair, const Motion& a, const Motion& b, double begin,
                                            double horizon, double tolerance);

/// The same against a half-space, which does not move.
[[nodiscard]] TimeOfContact time_of_contact(const ConvexShape& a, const Motion& motion, const HalfSpace& b,
                                            double begin, double horizon, double tolerance);

}  // namespace carom::scene
