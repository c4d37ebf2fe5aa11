// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stop_token>

#include <carom/scene/polyhedra/distance.hpp>
#include <carom/scene/polyhedra/free_flight.hpp>

namespace carom::scene {

/// How the search for a contact ended.
enum class ContactStatus {
  touches,    // within the tolerance at the returned time, and not before
  misses,     // certain to stay apart up to the horizon
  overlaps,   // not certain to be apart at the beginning
  undecided,  // certain to be apart up to the returned time; the tolerance is below the accuracy of the numbers, or the
              // search takes too long
};

struct TimeOfContact {
  ContactStatus status = ContactStatus::misses;
  double time = 0;        // [s]
  Separation separation;  // at the returned time
  int advances = 0;       // the number of separations that were computed
};

/// The first time in [begin, horizon] at which two moving shapes are within the tolerance [m] of each other and do not
/// draw apart. Up to and at that time, the shapes certainly do not touch, in the exact motion from the given numbers.
///
/// Conservative advancement (B. Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996) starts from a
/// certified separation along n at a time s. It advances the time while the gap along n certainly stays open, and then
/// finds a new n. Mirtich's bound of first order uses the greatest speed of any point. The bound here is of second
/// order: it uses the velocity of each vertex along n at s, and bounds only accelerations. The gap of two vertices
/// after the time Δ is
///
///     n·(x_v(s+Δ) − y_u(s+Δ)) ≥ n·(x_v − y_u) + Δ n·(ẋ_v − ẏ_u) + ½ Δ² n·(a_A − a_B) − ½ Δ² (C_A + C_B),
///     C = r ω² (1 + α/√3).
///
/// Here x_v and y_u are vertices of A and B, and a_A and a_B are the accelerations of the centres. For each body, r is
/// the greatest distance of a vertex from the centre, ω is the greatest rate of the whole motion, and ‖ω'‖ ≤ α ω²/√3
/// (RotationPath).
///
/// The search also tries directions n that turn at a constant rate Ω. If Ω is the angular velocity of A or of B, n
/// stays normal to a face. Another Ω keeps n perpendicular to an edge of each body. In axes that turn with n, a point x
/// relative to B's centre has the velocity ẋ − Ω × x. The second derivative of the gap is at most C_A + C_B + ‖a_A −
/// a_B‖ + 2 ‖Ω‖ ‖ẋ‖ + ‖Ω‖² ‖x‖. The search takes the longest step over all n. The shapes draw apart if the gap opens
/// along one of these n.
///
/// Bodies that do not move relative to each other never meet. Preconditions: both motions start at `begin` or before,
/// and end at the horizon or later; the tolerance is positive. If the tolerance is below the errors (about 2⁻⁴⁴ of
/// sizes and distance, plus the errors of the placements), the answer may be `undecided`. Then `time` is the last time
/// up to which the shapes are certainly apart. The answer is also `undecided` after a request to stop.
[[nodiscard]] TimeOfContact time_of_contact(const ShapePair& pair, const FreeFlight& a, const FreeFlight& b,
                                            double begin, double horizon, double tolerance,
                                            const std::stop_token& stop = {});

/// The first time of contact of a shape with a fixed half-space. Parameters and preconditions are those for two shapes.
[[nodiscard]] TimeOfContact time_of_contact(const ConvexShape& a, const FreeFlight& motion, const HalfSpace& b,
                                            double begin, double horizon, double tolerance,
                                            const std::stop_token& stop = {});

}  // namespace carom::scene
