// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/plan/contact_class.hpp>

namespace carom::properties::plan {
namespace {

using oracles::Rational;
using ExactBody = BasicBody<Rational>;

/// Above this ratio of moments, the solvers treat the long axis separately (principal_inertia.hpp).
constexpr int least_ratio_of_slender_moments = 8;

Rational squared_length(const Vector3<Rational>& v) { return v.dot(v); }

/// Whether ‖r × N‖ is at most about the effect of rounding P, X and N: 8u ‖N‖ (‖P‖ + ‖X‖), with u of binary64.
bool is_along_normal(const ExactBody& body, const BasicCollision<Rational>& c) {
  const Vector3<Rational> moment = oracles::lever_arm(body, c.point).cross(c.normal);
  // The larger 2 ‖P‖² + 2 ‖X‖² replaces (‖P‖ + ‖X‖)², so that no root is needed.
  const Rational squared_positions = Rational(2) * (squared_length(c.point) + squared_length(body.position));
  const Rational rounding(0x1p-50);
  return squared_length(moment) <= rounding * rounding * squared_length(c.normal) * squared_positions;
}

bool is_slender(const ExactBody& body) {
  const auto [least, greatest] =
      std::minmax_element(body.principal_inertia.data(), body.principal_inertia.data() + body.principal_inertia.size());
  return *greatest > Rational(least_ratio_of_slender_moments) * *least;
}

bool has_equal_moments(const ExactBody& body) {
  return body.principal_inertia[0] == body.principal_inertia[1] &&
         body.principal_inertia[1] == body.principal_inertia[2];
}

/// Whether it holds for each movable body.
template <class Holds>
bool of_each_movable(const BasicCollision<Rational>& c, const Holds& holds) {
  return (c.a.immovable || holds(c.a)) && (c.b.immovable || holds(c.b));
}

TorqueForm form_of(const BasicCollision<Rational>& c) {
  if (of_each_movable(c, has_equal_moments)) {
    return TorqueForm::equal;
  }
  return of_each_movable(c, [](const ExactBody& body) { return !is_slender(body); }) ? TorqueForm::plain
                                                                                     : TorqueForm::accurate;
}

const char* kind_of(const BasicCollision<Rational>& c) {
  if (of_each_movable(c, [&](const ExactBody& body) { return is_along_normal(body, c); })) {
    return "central";
  }
  switch (form_of(c)) {
    case TorqueForm::equal:
      return "equal moments";
    case TorqueForm::plain:
      return "general";
    case TorqueForm::accurate:
      break;
  }
  return "slender";
}

}  // namespace

std::string contact_class_of(const Collision& collision) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  if (collision.a.immovable && collision.b.immovable) {
    return "both immovable";
  }
  const bool is_against_immovable = collision.a.immovable || collision.b.immovable;
  return std::string(kind_of(oracles::lift(collision))) + (is_against_immovable ? ", one immovable" : ", both movable");
}

TorqueForm torque_form_of(const Collision& collision) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  return form_of(oracles::lift(collision));
}

}  // namespace carom::properties::plan
