// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>

namespace carom::scene {

/// The exact sign of (b − a) × (c − a) · (d − a): +1 if d lies on the side from which a, b, c appear counterclockwise,
/// and 0 if the four points share a plane. If the error bound of J. Shewchuk ("Adaptive precision floating-point
/// arithmetic and fast robust geometric predicates", Discrete Comput. Geom. 18, 1997, `o3derrboundA`) leaves the sign
/// open, rational numbers decide. Precondition: every number is finite.
[[nodiscard]] int orientation(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                              const Vector3<double>& d);

/// The exact signs of the components of (b − a) × (c − a), all 0 if the three points share a line. Precondition: every
/// number is finite.
[[nodiscard]] Vector3<int> normal_signs(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c);

}  // namespace carom::scene
