// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/collision/precision.hpp>
#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/laws/mechanics.hpp>
#include <carom/properties/gate/unjudged.hpp>

namespace carom::properties {
namespace {

using oracles::norm_of;

/// Checks that sizes stay away from the limits of binary32.
class RangeOfBinary32 {
 public:
  void require(double size) {
    constexpr int largest_exponent = 120;
    int exponent = 0;
    std::frexp(size, &exponent);
    holds_ = holds_ && std::isfinite(size) && (size == 0 || std::abs(exponent) <= largest_exponent);
  }
  [[nodiscard]] bool holds() const { return holds_; }

 private:
  bool holds_ = true;
};

/// `rounding` is the rounding error of N·V⁻ / ‖N‖.
bool stays_in_binary32(const Collision& c, double rounding) {
  RangeOfBinary32 range;
  double lightest = 0;  // the smaller mass, which bounds the impulse
  double fastest = 0;
  for (const Body* body : {&c.a, &c.b}) {
    const double length = norm_of(oracles::lever_arm<double>(*body, c.point));
    const double spin = norm_of(body->angular_velocity);
    fastest = std::max({fastest, norm_of(body->velocity), spin * length});
    range.require(norm_of(body->velocity));
    range.require(spin);
    if (body->immovable) {
      continue;
    }
    lightest = lightest == 0 ? body->mass : std::min(lightest, body->mass);
    range.require(body->mass);
    for (const double moment : body->principal_inertia) {
      range.require(moment);
      range.require(length / moment);
      range.require(length / moment * length);
    }
  }
  // The impulse depends on the speed of approach, or on its rounding if that is larger. Intermediate results may depend
  // on the fastest speed.
  const double approach = std::abs(oracles::normal_velocity_before(c)) / norm_of(c.normal);
  for (const double speed : {std::max(approach, rounding), fastest}) {
    range.require(speed);
    range.require(lightest * speed);
    for (const Body* body : {&c.a, &c.b}) {
      if (!body->immovable) {
        const double torque = lightest * speed * norm_of(oracles::lever_arm<double>(*body, c.point));
        range.require(torque);
        range.require(torque / body->principal_inertia.minCoeff());
        range.require(torque / body->principal_inertia.maxCoeff());
      }
    }
  }
  return range.holds();
}

}  // namespace

std::string_view name_of(Unjudged reason) {
  switch (reason) {
    case Unjudged::leaves_range:
      return "leaves_range";
    case Unjudged::no_finite_enclosure:
      return "no_finite_enclosure";
    case Unjudged::at_declared_limit:
      break;
  }
  return "at_declared_limit";
}

std::string_view in_words(Unjudged reason) {
  switch (reason) {
    case Unjudged::leaves_range:
      return "a mass, a moment of inertia, the impulse or its torque leaves the range of the precision";
    case Unjudged::no_finite_enclosure:
      return "the enclosure of the law over the permitted inputs is unbounded";
    case Unjudged::at_declared_limit:
      break;
  }
  return "rounding decides whether the declared threshold or slop applies";
}

std::optional<Unjudged> reason_unjudged(const oracles::ExactCase& exact_case, const oracles::Yardstick& yardstick) {
  const double u = yardstick.unit_roundoff();
  if (u >= unit_roundoff(Precision::binary32)) {
    const Collision& c = exact_case.collision();
    if (!stays_in_binary32(c, u * exact_case.normal_velocity_sensitivity() / norm_of(c.normal))) {
      return Unjudged::leaves_range;
    }
  }
  const oracles::PermittedInputs* permitted = exact_case.permitted_inputs(yardstick.allowance());
  if (permitted != nullptr && !permitted->is_finite()) {
    return Unjudged::no_finite_enclosure;
  }
  return std::nullopt;
}

}  // namespace carom::properties
