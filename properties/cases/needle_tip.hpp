// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/cases/family.hpp>

namespace carom::properties {

/// A convex body of uniform density, 10 to 10⁶ times as long as wide, that is struck on its tip along its long axis.
/// The other body is immovable, a second such needle, or any convex body of uniform density.
///
/// The angle between N and the long axis is zero or 10^-k, with k = 1 to 18. Likewise, the tangential part of V⁻ is
/// zero or 10^-k times the normal part. So lever arm, impulse and long axis are nearly parallel, and the torque is the
/// small difference of large products.
[[nodiscard]] Case needle_tip(Stream& stream);

}  // namespace carom::properties
