// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <carom/collision/collision.hpp>

namespace carom::properties {

/// Why a subject of this unit roundoff u cannot hold the collision, whatever it computes; empty where it can. Lever
/// arms are lost in the places that they are differences of where 1024 u max(‖P‖, ‖X‖) > ‖r‖, r ≠ 0: the 32 ulps by
/// which inputs may move by default then change r by more than a 32nd, and the first order of the backward error says
/// little. The rounding of w × r is to be no more than 32 times what the rounding of inputs makes of N·V: where w, r
/// and N are parallel the inputs account for nothing, and a solver is right by luck alone. And where u is that of
/// binary32, what any law makes of a contact (masses, moments, impulse, torque) has to stay 2⁶ away from the ends of
/// its range. Precondition: the collision is valid.
[[nodiscard]] std::string_view why_not_held(const Collision& collision, double unit_roundoff);

}  // namespace carom::properties
