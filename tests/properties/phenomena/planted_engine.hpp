// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/stepper.hpp>

namespace carom::phenomena_tests {

/// The switches of the sixteen defects. By default, all are off.
struct Defects {
  bool friction_an_impulse_a_step = false;  // the limit of friction is a force, but it is applied as an impulse
  double restitution_threshold = 0;         // no bounce below this speed [m/s]
  bool restitution_after_gravity = false;   // the speed that restitution turns has the step's gravity in it
  double speculation = 0;  // a body just touches what is nearer than this, and then it bounces with less speed [m]
  double torque = 1;       // this share of the torque of an impulse acts: a bounce without spin has 0
  double push_out = 0;     // this share of a penetration becomes a velocity in a step
  double damping = 0;      // this share of the velocity is lost in a second
  bool no_gyroscopic_term = false;         // the angular velocity of a free body stays
  bool explicit_gyroscopic_term = false;   // by Euler's explicit method
  bool contacts_a_step_late = false;       // from the places one step before
  bool binary32_state = false;             // the state is rounded to binary32 after each step
  Vector3<double> friction_axes{1, 1, 1};  // friction acts along them: friction of one axis has one 1
  bool friction_beyond_the_cone = false;   // without a limit
  unsigned corners = 8;                    // of a box that can touch: a box with one contact point has 1
  bool insertion_order = false;            // contacts are solved in the order in which bodies were added
  bool surviving_warm_starts = false;      // the impulses of the last run are the first guess of the next
};

/// Symplectic Euler with impulses at the ends of steps, for spheres, boxes and half-spaces. Boxes pass through each
/// other. Impulses are found contact by contact, with warm starts, until they change no velocity by more than rounding.
/// Nothing removes a penetration.
[[nodiscard]] Stepper planted_engine(const Defects& defects);

}  // namespace carom::phenomena_tests
