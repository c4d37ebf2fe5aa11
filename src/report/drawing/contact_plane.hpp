// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <carom/collision/collision.hpp>
#include <carom/report/drawing/drawing.hpp>

/// The plane that a contact is drawn in. In extended numbers: differences and squares of any binary64 numbers are in
/// their range.
namespace carom::report {

using Direction = Vector3<long double>;

struct Plane {
  Direction across;
  Direction up;                 // along the normal
  std::string_view spanned_by;  // in words
};

/// The plane of the normal and of what is most askew to it: the relative velocity, or a movable body's lever arm.
/// Precondition: the numbers are finite and the normal is not zero.
[[nodiscard]] Plane contact_plane(const Collision& collision, const Vector3<double>& relative_velocity);

[[nodiscard]] Place projected(const Plane& plane, const Direction& vector);

/// The outline, seen in the plane, of the ellipsoid of uniform density that has the body's mass and inertia.
struct Outline {
  long double longer = 0;  // semi-axes
  long double shorter = 0;
  long double turned = 0;  // of the longer one, counter-clockwise from `across` [rad]
};

/// Precondition: the body is movable and valid.
[[nodiscard]] Outline outline(const Plane& plane, const Body& body);

}  // namespace carom::report
