// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/report/pictures/contact_plane.hpp>

namespace carom::report {
namespace {

/// The unit vector of a vector; zero for a zero vector.
Direction unit(const Direction& vector) {
  const long double largest = vector.cwiseAbs().maxCoeff();
  return largest > 0 ? Direction((vector / largest).normalized()) : Direction(Direction::Zero());
}

/// The unit vector of `vector`, without the component along the normal.
Direction askew(const Direction& vector, const Direction& normal) {
  const Direction direction = unit(vector);
  return direction - direction.dot(normal) * normal;
}

Direction any_orthogonal(const Direction& normal) {
  int smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  return askew(Direction::Unit(smallest), normal).normalized();
}

}  // namespace

Plane contact_plane(const Collision& collision, const Vector3<double>& relative_velocity) {
  CAROM_EXPECTS(collision.normal.allFinite() && !collision.normal.isZero(0), collision.normal);
  struct Candidate {
    Direction askew;
    std::string_view name;
  };
  const Direction normal = unit(collision.normal.cast<long double>());
  Candidate best{askew(relative_velocity.cast<long double>(), normal), "the velocity of the contact point"};
  for (const auto& [body, name] :
       {std::pair{&collision.a, "the lever arm of A"}, std::pair{&collision.b, "the lever arm of B"}}) {
    const Direction arm = collision.point.cast<long double>() - body->position.cast<long double>();
    const Candidate candidate{askew(arm, normal), name};
    if (!body->immovable && candidate.askew.norm() > best.askew.norm()) {
      best = candidate;
    }
  }
  // A length below `visible` is rounding error of the subtraction in `askew`.
  constexpr long double visible = 1e-12L;
  return best.askew.norm() > visible ? Plane{best.askew.normalized(), normal, best.name}
                                     : Plane{any_orthogonal(normal), normal, "any direction orthogonal to N"};
}

Place projected(const Plane& plane, const Direction& vector) {
  return {vector.dot(plane.across), vector.dot(plane.up)};
}

Outline outline(const Plane& plane, const Body& body) {
  CAROM_EXPECTS(!body.immovable && body.mass > 0 && body.principal_inertia.minCoeff() > 0, body.mass,
                body.principal_inertia);
  const Direction inertia = body.principal_inertia.cast<long double>();
  const Quaternion<long double> orientation = body.orientation.cast<long double>();
  // A uniform ellipsoid with semi-axes a, b and c has I_x = m (b² + c²) / 5, and so on. Hence a² = 5 (I_y + I_z − I_x)
  // / 2m. The matrix of the outline is Σ p pᵀ, over the semi-axes p projected into the plane.
  long double xx = 0;
  long double xy = 0;
  long double yy = 0;
  for (int i = 0; i < 3; ++i) {
    const long double squared = 5 * (inertia.sum() - 2 * inertia[i]) / (2 * static_cast<long double>(body.mass));
    const Place axis = projected(plane, oracles::turned<long double>(orientation, Direction::Unit(i)));
    const long double kept = std::max(squared, 0.0L);  // some valid bodies have the inertia of no ellipsoid
    xx += kept * axis.x * axis.x;
    xy += kept * axis.x * axis.y;
    yy += kept * axis.y * axis.y;
  }
  const long double mean = (xx + yy) / 2;
  const long double spread = std::hypot((xx - yy) / 2, xy);
  return {std::sqrt(mean + spread), std::sqrt(std::max(mean - spread, 0.0L)), std::atan2(2 * xy, xx - yy) / 2};
}

}  // namespace carom::report
