// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>

namespace carom::scene {

/// The sign of (b − a) × (c − a) · (d − a), exactly: +1 where d lies on the side from which a, b, c turn
/// counterclockwise, 0 where the four points share a plane. A floating-point value decides where its error bound (J.
/// Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", Discrete Comput.
/// Geom. 18, 1997, `o3derrboundA`) lets it, rationals where not. Precondition: every number is finite.
[[nodiscard]] int orientation(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                              const Vector3<double>& d);

/// The signs of the components of (b − a) × (c − a), exactly: all 0 where the three points share a line.
/// Precondition: every number is finite.
[[nodiscard]] Vector3<int> normal_signs(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c);

}  // namespace carom::scene
