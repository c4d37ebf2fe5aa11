// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <carom/collision/collision.hpp>
#include <carom/report/pictures/drawing.hpp>

/// The plane in which a contact is drawn. Its numbers are long double, so that differences and squares of any binary64
/// numbers neither overflow nor underflow.
namespace carom::report {

using Direction = Vector3<long double>;

struct Plane {
  Direction across;
  Direction up;                 // along the normal
  std::string_view spanned_by;  // in words
};

/// The plane of the normal N and of a second vector. The second vector is the relative velocity or a movable body's
/// lever arm, whichever is least parallel to N. Precondition: the numbers are finite and the normal is not zero.
[[nodiscard]] Plane contact_plane(const Collision& collision, const Vector3<double>& relative_velocity);

[[nodiscard]] Place projected(const Plane& plane, const Direction& vector);

/// The outline, projected into the plane, of the uniform ellipsoid with the body's mass and inertia.
struct Outline {
  long double longer = 0;  // semi-axes [m]
  long double shorter = 0;
  long double turned = 0;  // angle of the longer axis, counter-clockwise from `across` [rad]
};

/// Precondition: the body is movable and valid.
[[nodiscard]] Outline outline(const Plane& plane, const Body& body);

}  // namespace carom::report
