// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include <carom/collision/vector.hpp>

namespace carom::formulas {

/// Two directions p and q = n × p orthogonal to a unit normal n. If |n_z| > 1/√2, p ∥ (0, −n_z, n_y), else p ∥ (−n_y,
/// n_x, 0). Both have length 1. Source: Bullet's btPlaneSpace1 (LinearMath/btVector3.h), from ODE's dPlaneSpace
/// (ode/src/odemath.cpp).
struct PlaneSpace {
  Vector3<double> p;
  Vector3<double> q;
};
[[nodiscard]] inline PlaneSpace plane_space(const Vector3<double>& n) {
  const Vector3<double> p = std::abs(n.z()) > std::sqrt(0.5) ? Vector3<double>(0, -n.z(), n.y()).normalized()
                                                             : Vector3<double>(-n.y(), n.x(), 0).normalized();
  return {p, n.cross(p)};
}

}  // namespace carom::formulas
