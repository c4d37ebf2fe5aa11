// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <carom/collision/expects.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/truths/models.hpp>

namespace carom::oracles {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

PermittedInputs::PermittedInputs(const ExactCase& exact_case, double allowance) : allowance_(allowance) {
  CAROM_EXPECTS(0 < allowance && allowance < 0.5, allowance);
  const Collision& c = exact_case.collision();
  const VectorBall point = vector(c.point);
  const auto body_with_arm = [&](const Body& body) -> OfBody {
    const VectorBall position{body.position, allowance * length_of_position(body)};
    return {body, point - position};
  };
  a_ = body_with_arm(c.a);
  b_ = body_with_arm(c.b);
  // The allowance α moves N by at most α ‖N‖, and so turns N by at most asin(α). The chord of this angle is less than
  // α / (1 − α).
  unit_normal_ = {c.normal / norm_of(c.normal), allowance / (1 - allowance)};
  const auto at_point = [&](const OfBody& of) {
    return vector(of.body.velocity) + cross(vector(of.body.angular_velocity), of.arm);
  };
  relative_velocity_ = {exact_case.relative_velocity(), (at_point(a_) - at_point(b_)).radius};
  normal_velocity_ = dot(unit_normal_, relative_velocity_);
  restitution_ = scalar(c.restitution);
  friction_ = scalar(c.friction);
  whole_share_ = ScalarBall{1, 0} + scalar(c.tangential_restitution);
  least_inverse_mass_ = inverse_mass(c) / (1 + allowance);
}

bool PermittedInputs::derivatives_fail(const Collision& c, double allowance, double normal_velocity_sensitivity) {
  constexpr double safety_factor = 32;
  double products = 0;
  for (const Body* body : {&c.a, &c.b}) {
    const double length = norm_of(lever_arm<double>(*body, c.point));
    products += norm_of(body->angular_velocity) * length;
    if (body->immovable) {
      continue;
    }
    const double rounding = safety_factor * allowance * length_of_lever_arm(*body, c.point);
    if ((length > 0 && rounding > length) ||
        rounding > std::sqrt(body->principal_inertia.minCoeff()) / std::sqrt(body->mass)) {
      return true;
    }
  }
  return norm_of(c.normal) * products > safety_factor * normal_velocity_sensitivity;
}

bool PermittedInputs::is_finite() const {
  // The radii of the arms and of V⁻ enter these radii. So if these are finite, all are.
  return std::isfinite(normal_velocity_.radius) && std::isfinite(response_at_point(unit_normal_).largest());
}

/// If a quaternion changes by α of its length, v turns by at most 2 asin(α), and so moves by at most 2 α ‖v‖.
VectorBall PermittedInputs::rotated(const VectorBall& v, const Quaternion<double>& orientation) const {
  return {turned<double>(orientation, v.centre), v.radius + 2 * allowance_ * v.largest()};
}

PermittedInputs::Change PermittedInputs::response(const OfBody& of, const VectorBall& impulse) const {
  if (of.body.immovable) {
    return {};
  }
  const double growth = 1 / (1 - allowance_);  // of the reciprocal of a mass or a moment
  const ScalarBall inverse{1 / of.body.mass, allowance_ * growth / of.body.mass};
  const VectorBall torque = rotated(cross(of.arm, impulse), conjugate(of.body.orientation));
  const Vector3<double> spin = torque.centre.cwiseQuotient(of.body.principal_inertia);
  const VectorBall in_body{
      spin, growth * (torque.radius / of.body.principal_inertia.minCoeff() + allowance_ * norm_of(spin))};
  return {inverse * impulse, rotated(in_body, of.body.orientation)};
}

VectorBall PermittedInputs::response_at_point(const VectorBall& impulse) const {
  VectorBall sum;
  for (const OfBody* of : {&a_, &b_}) {
    const Change change = response(*of, impulse);
    sum = sum + change.velocity + cross(change.angular_velocity, of->arm);
  }
  return sum;
}

/// For F = φ N and F′ = φ′ N′, φ′ − φ = (N′·K′ F′ − N′·K′ φ N′) / (N′·K′ N′). The divisor is at least λ for a unit
/// normal N′.
VectorBall PermittedInputs::along_normal(const Vector3<double>& impulse, double radius) const {
  const double share = unit_normal_.centre.dot(impulse);
  const ScalarBall along{share, 0};
  const double missed = radius + dot(unit_normal_, response_at_point(along * unit_normal_)).radius;
  const double divisor = std::max(least_inverse_mass_, dot(unit_normal_, response_at_point(unit_normal_)).least());
  return ScalarBall{share, missed / divisor} * unit_normal_;
}

/// F′ − F = K′⁻¹ (K′ F′ − K′ F) is at most ‖K′ F′ − K′ F‖ / λ long.
VectorBall PermittedInputs::by_matrix(const Vector3<double>& impulse, double radius) const {
  const double missed = radius + response_at_point({impulse, 0}).radius;
  return {impulse, missed / least_inverse_mass_};
}

PermittedInputs::RoughParts PermittedInputs::rough_parts(const ExactCase& exact_case) const {
  const VectorBall stops_approach = along_normal(exact_case.stop_impulses().of_approach, normal_velocity_.radius);
  const VectorBall stops_point = by_matrix(exact_case.stop_impulses().of_point, relative_velocity_.radius);
  const VectorBall difference = stops_point - stops_approach;
  const ScalarBall numerator = friction_ * (ScalarBall{1, 0} + restitution_) * dot(unit_normal_, stops_approach);
  const VectorBall tangential = cross(unit_normal_, difference);
  const ScalarBall divisor =
      ScalarBall{norm_of(tangential.centre), tangential.radius} + -(friction_ * dot(unit_normal_, difference));
  // F lies in the convex cone for κ = 0. So, as κ grows, F leaves the cone at most once: at the κ that puts F on the
  // surface.
  const auto share = [](double above, double below) { return below > 0 ? std::max(above, 0.0) / below : infinity; };
  return {stops_approach, difference, share(numerator.least(), divisor.largest()),
          share(numerator.largest(), divisor.least())};
}

VectorBall PermittedInputs::rough(const ExactCase& exact_case, const Vector3<double>& impulse) const {
  const RoughParts parts = rough_parts(exact_case);
  const VectorBall along = (ScalarBall{1, 0} + restitution_) * parts.stops_approach;
  const Vector3<double>& d = parts.difference.centre;
  const Vector3<double> friction = impulse - along.centre;
  const double length = norm_of(d);
  const double share = length > 0 ? friction.dot(d / length) / length : 0;
  const double least = std::min(whole_share_.least(), parts.least_share);
  const double largest = std::min(whole_share_.largest(), parts.largest_share);
  const double change = std::max({largest - share, share - least, 0.0});
  return {impulse, along.radius + largest * parts.difference.radius + change * length};
}

VectorBall PermittedInputs::impulses(const ExactCase& exact_case, const Vector3<double>& impulse, Law law,
                                     Branch branch) const {
  const ScalarBall rebound = ScalarBall{1, 0} + restitution_;
  switch (law == Law::rough && branch == Branch::only ? Law::frictionless : law) {
    case Law::frictionless:
      return along_normal(impulse, (rebound * normal_velocity_).radius);
    case Law::reflection:
      return by_matrix(impulse, ((rebound * normal_velocity_) * unit_normal_).radius);
    case Law::sticking:
      return by_matrix(impulse, (relative_velocity_ + (restitution_ * normal_velocity_) * unit_normal_).radius);
    case Law::rough:
      return rough(exact_case, impulse);
    case Law::coulomb:
    case Law::any:
      break;
  }
  determines_no_outcome(law);
}

PerVector<double> PermittedInputs::distance_of_answers(const ExactCase& exact_case, const Vector3<double>& impulse,
                                                       Law law, Branch branch, bool from_rest) const {
  CAROM_EXPECTS(!(a_.body.immovable && b_.body.immovable));
  VectorBall all = impulses(exact_case, impulse, law, branch);
  if (from_rest) {
    all = {Vector3<double>::Zero(), all.largest()};
  }
  PerVector<double> distance{};
  const auto add_body = [&](const OfBody& of, OutcomeVector velocity, OutcomeVector spin) {
    const Change change = response(of, all);
    // The velocity before the impulse counts twice: as a perturbed input, and in the rounding of its sum with the
    // change.
    distance[velocity] = change.velocity.radius + 2 * allowance_ * norm_of(of.body.velocity);
    distance[spin] = change.angular_velocity.radius + 2 * allowance_ * norm_of(of.body.angular_velocity);
  };
  add_body(a_, OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a);
  add_body(b_, OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b);
  for (const OutcomeVector k : all_outcome_vectors) {
    if (!std::isfinite(distance[k])) {
      distance[k] = infinity;
    }
  }
  return distance;
}

double PermittedInputs::second_order_of_matrix() const {
  double sum = 0;
  for (const OfBody* of : {&a_, &b_}) {
    if (!of->body.immovable) {
      // The matrix [δr] with [δr] y = δr × y has the Frobenius norm √2 ‖δr‖.
      sum += std::sqrt(2.0) * of->arm.radius * of->arm.radius / of->body.principal_inertia.minCoeff();
    }
  }
  return sum;
}

bool PermittedInputs::reach_both_sides_of_cone(const ExactCase& exact_case) const {
  CAROM_EXPECTS(!(a_.body.immovable && b_.body.immovable));
  const RoughParts parts = rough_parts(exact_case);
  return !(parts.least_share > whole_share_.largest()) && !(parts.largest_share < whole_share_.least());
}

}  // namespace carom::oracles
