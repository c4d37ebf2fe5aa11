// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/stepper.hpp>

namespace carom::phenomena_tests {

enum class Defect {
  none,
  friction_an_impulse_a_step,  // the limit of friction is a force, but it is applied as an impulse
  restitution_threshold,       // no bounce below 0.5 m/s
  restitution_after_gravity,   // the speed that restitution turns has the step's gravity in it
  speculative_contacts,        // a body is slowed down so that it just touches, and then it bounces with that speed
  bounce_without_spin,         // the friction of a bounce has no torque
  pushed_out_with_velocity,    // penetration becomes a velocity
  damping,                     // a tenth of the velocity a second
  no_gyroscopic_term,          // the angular velocity of a free body stays
  explicit_gyroscopic_term,    // by Euler's explicit method
  contacts_a_step_late,        // from the places one step before
  binary32_state,              // the state is rounded to binary32 after each step
  friction_of_one_axis,        // along x alone
  friction_beyond_the_cone,    // without a limit
  one_contact_point,           // of two bodies
  insertion_order,             // contacts are solved in the order in which bodies were added
  surviving_warm_starts        // the impulses of the last run are the first guess of the next
};

/// Symplectic Euler with impulses at the ends of steps, for spheres, boxes and half-spaces, and one defect. Boxes pass
/// through each other. Impulses are found contact by contact, with warm starts, until they change no velocity by more
/// than rounding. Nothing removes a penetration.
[[nodiscard]] Stepper planted_engine(Defect defect);

}  // namespace carom::phenomena_tests
