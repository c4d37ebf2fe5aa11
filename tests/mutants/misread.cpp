// SPDX-License-Identifier: BSL-1.0
#include "misread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::mutants {
namespace {

bool is_at_rest(const Body& body) {
  return (body.velocity.array() == 0).all() && (body.angular_velocity.array() == 0).all();
}

/// If two moments are equal, sets the third moment to the same value.
void take_for_sphere(Vector3<double>& moments) {
  for (int i = 0; i < 3; ++i) {
    if (moments[i] == moments[(i + 1) % 3]) {
      moments.setConstant(moments[i]);
      return;
    }
  }
}

Vector3<double> in_fixed_point(const Vector3<double>& velocity) {
  constexpr double step = 1e-9;  // [m/s]
  return (velocity / step).array().round() * step;
}

Vector3<double> along_axis_if_near(const Vector3<double>& normal) {
  constexpr double near = 0.999;
  int axis = 0;
  const double largest = normal.cwiseAbs().maxCoeff(&axis);
  return largest < near * normal.stableNorm()
             ? normal
             : Vector3<double>(Vector3<double>::Unit(axis) * std::copysign(largest, normal[axis]));
}

Body misread(Defect defect, Body body, const Body& other) {
  Quaternion<double>& q = body.orientation;
  switch (defect) {
    case Defect::negative_quaternion_conjugated:
      q[0] = std::abs(q[0]);
      break;
    case Defect::small_turn_as_none: {
      constexpr double small = 0.95;  // cosine of half the angle
      if (std::abs(q[0]) > small * q.stableNorm()) {
        q = {1, 0, 0, 0};
      }
      break;
    }
    case Defect::half_turn_divides:
      if (q[0] == 0) {
        q.setConstant(std::numeric_limits<double>::quiet_NaN());
      }
      break;
    case Defect::two_equal_moments_as_sphere:
      take_for_sphere(body.principal_inertia);
      break;
    case Defect::moments_sorted:
      std::sort(body.principal_inertia.begin(), body.principal_inertia.end());
      break;
    case Defect::inverse_moments_capped: {
      constexpr double least = 1e-6;  // [kg m²]
      body.principal_inertia = body.principal_inertia.cwiseMax(least);
      break;
    }
    case Defect::small_moments_as_infinite: {
      constexpr double least_product = 1e-32;
      if (body.principal_inertia.prod() < least_product) {
        body.principal_inertia.setConstant(std::numeric_limits<double>::infinity());
      }
      break;
    }
    case Defect::velocities_in_fixed_point:
      body.velocity = in_fixed_point(body.velocity);
      break;
    case Defect::heavy_as_immovable: {
      constexpr double ratio = 1e6;
      body.immovable = body.immovable || (!other.immovable && body.mass >= ratio * other.mass);
      break;
    }
    case Defect::resting_body_asleep:
      body.immovable = body.immovable || is_at_rest(body);
      break;
    default:  // the other defects do not affect reading the bodies
      break;
  }
  return body;
}

double restitution_as_read(Defect defect, const Collision& c) {
  switch (defect) {
    case Defect::restitution_ignored:
      return 0;
    case Defect::restitution_by_place: {
      constexpr double share = 0.1;
      return c.restitution * (1 - share * std::abs(std::sin(c.point[0])));
    }
    case Defect::restitution_from_friction:
      return c.friction > 0 ? std::min(1.0, (c.restitution + c.friction) / 2) : c.restitution;
    case Defect::elastic_lossy: {
      constexpr double loss = 1e-9;
      return c.restitution == 1 ? 1 - loss : c.restitution;
    }
    default:
      return c.restitution;
  }
}

}  // namespace

Collision misread(std::span<const Defect> defects, const Collision& collision) {
  Collision read = collision;
  for (const Defect defect : defects) {
    const Collision before = read;
    read.a = misread(defect, before.a, before.b);
    read.b = misread(defect, before.b, before.a);
    read.restitution = restitution_as_read(defect, before);
    if (defect == Defect::near_axis_as_axis) {
      read.normal = along_axis_if_near(before.normal);
    }
  }
  return read;
}

}  // namespace carom::mutants
