// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <Eigen/LU>

#include <carom/collision/expects.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/truths/coulomb.hpp>
#include <carom/properties/diagnosis/friction.hpp>
#include <carom/properties/diagnosis/precision.hpp>

namespace carom::properties::diagnosis {
namespace {

template <class S>
Matrix3<S> right_inverse_inertia(const BasicBody<S>& body) {
  Matrix3<S> axes;
  for (int i = 0; i < 3; ++i) {
    axes.col(i) = oracles::turned<S>(body.orientation, Vector3<S>::Unit(i));
  }
  return axes * body.principal_inertia.cwiseInverse().asDiagonal() * axes.transpose();
}

/// J⁻¹ of A or B by a formula. The mistaken formulas are known in extended precision only.
template <class S>
Matrix3<S> inverse_by(InverseInertia formula, const BasicCollision<S>& collision, bool is_of_a) {
  if (formula == inverse_inertia) {
    return right_inverse_inertia(is_of_a ? collision.a : collision.b);
  }
  const BasicCollision<Wide> wide = map_numbers<Wide>(collision, [](S x) { return static_cast<Wide>(x); });
  return formula(is_of_a ? wide.a : wide.b).template cast<S>();
}

/// A vector that may be given as an expression, so that the scalar is deduced from other arguments.
template <class S>
using Given = std::type_identity_t<Vector3<S>>;

/// The numbers of a contact that a solver uses.
template <class S>
struct Numbers {
  Matrix3<S> k = Matrix3<S>::Zero();
  Matrix3<S> by_turning = Matrix3<S>::Zero();  // K − λI
  S inverse_mass = 0;                          // λ
  Vector3<S> normal;                           // of length 1
  S approach = 0;                              // N·V⁻ / ‖N‖
  Vector3<S> slip;
  S read_spin = 1;  // the factor of the spins in the slip
  S restitution = 0;
  S friction = 0;
  S tangential_restitution = 0;
};

template <class S>
Vector3<S> across(const Numbers<S>& of, const Given<S>& v) {
  return v - of.normal * of.normal.dot(v);
}

template <class S>
Matrix3<S> cross_matrix(const Vector3<S>& r) {
  Matrix3<S> matrix;
  matrix << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  return matrix;
}

template <class S>
Numbers<S> numbers_of(const Collision& collision, const FrictionSteps& steps, const MatrixSteps& matrix) {
  const BasicCollision<S> c = map_numbers<S>(collision, [](double x) { return static_cast<S>(x); });
  Numbers<S> of;
  of.normal = c.normal.stableNormalized();
  Vector3<S> by_spins = Vector3<S>::Zero();
  Vector3<S> by_read_spins = Vector3<S>::Zero();
  for (const auto* body : {&c.a, &c.b}) {
    const bool is_a = body == &c.a;
    const S sign = is_a ? 1 : -1;
    const auto factor = static_cast<S>(is_a ? steps.spin_of_a : steps.spin_of_b);
    const Vector3<S> arm = oracles::lever_arm(*body, c.point);
    const Vector3<S> read = steps.has_arms_of_length_1 ? Vector3<S>(arm.stableNormalized()) : arm;
    by_spins += sign * body->angular_velocity.cross(arm);
    by_read_spins += sign * factor * body->angular_velocity.cross(read);
    if (!body->immovable) {
      of.inverse_mass += 1 / body->mass;
      const Matrix3<S> r = cross_matrix(arm);
      of.by_turning -= r * inverse_by(is_a ? matrix.inverse_of_a : matrix.inverse_of_b, c, is_a) * r;
    }
  }
  of.k = of.by_turning + Matrix3<S>::Identity() * (of.inverse_mass + static_cast<S>(matrix.added));
  if (matrix.is_diagonal) {
    of.k = Matrix3<S>(of.k.diagonal().asDiagonal());
  }
  of.read_spin = static_cast<S>(steps.spin_of_a == 1 ? steps.spin_of_b : steps.spin_of_a);
  const Vector3<S> of_centres = c.a.velocity - c.b.velocity;
  of.approach = of.normal.dot(of_centres + by_spins);
  of.slip = across(of, of_centres + by_read_spins);
  of.restitution = c.restitution;
  of.friction = c.friction;
  of.tangential_restitution = c.tangential_restitution;
  return of;
}

/// N·V⁺ − N·V⁻ by restitution, with N of length 1.
template <class S>
S rebound(const Numbers<S>& of) {
  return -(1 + of.restitution) * of.approach;
}

template <class S>
S frictionless(const Numbers<S>& of) {
  return rebound(of) / of.normal.dot(of.k * of.normal);
}

/// Two tangents of length 1.
template <class S>
std::pair<Vector3<S>, Vector3<S>> tangents_of(const Numbers<S>& of, Tangents tangents) {
  const Vector3<S>& n = of.normal;
  const auto with = [&](const Vector3<S>& first) {
    const Vector3<S> t = first.normalized();
    return std::pair(t, Vector3<S>(n.cross(t)));
  };
  switch (tangents) {
    case Tangents::beside_normal:
      return with(std::abs(n[0]) < std::abs(n[2]) ? Vector3<S>(0, -n[2], n[1]) : Vector3<S>(-n[1], n[0], 0));
    case Tangents::of_least_axis: {
      int axis = 0;
      n.cwiseAbs().minCoeff(&axis);
      return with(across(of, Vector3<S>::Unit(axis)));
    }
    case Tangents::branchless: {
      const S sign = std::copysign(S{1}, n[2]);
      const S a = -1 / (sign + n[2]);
      return with({1 + sign * n[0] * n[0] * a, sign * n[0] * n[1] * a, -sign * n[0]});
    }
    case Tangents::of_slip:
      break;
  }
  return of.slip.isZero(0) ? tangents_of(of, Tangents::of_least_axis) : with(of.slip);
}

/// A tangential impulse within a limit. No value if its direction is not known.
template <class S>
std::optional<Vector3<S>> limited(const Numbers<S>& of, const FrictionSteps& steps, const Given<S>& impulse, S limit) {
  const S length = impulse.stableNorm();
  switch (steps.limit) {
    case FrictionLimit::cone:
      return length > limit ? Vector3<S>(impulse * (limit / length)) : impulse;
    case FrictionLimit::none:
      return impulse;
    case FrictionLimit::always:
      return length > 0 ? std::optional(Vector3<S>(impulse * (limit / length))) : std::nullopt;
    case FrictionLimit::box:
    case FrictionLimit::pyramid:
      break;
  }
  const auto [first, second] = tangents_of(of, steps.tangents);
  S x = impulse.dot(first);
  S y = impulse.dot(second);
  if (steps.limit == FrictionLimit::box) {
    x = std::clamp(x, -limit, limit);
    y = std::clamp(y, -limit, limit);
  } else {
    const S share = std::min<S>(1, limit / std::max(std::abs(x) + std::abs(y), limit));
    x *= share;
    y *= share;
  }
  return Vector3<S>(first * x + second * y);
}

/// The tangential impulse that stops this slip, in a solver of one pass.
template <class S>
Vector3<S> stopping(const Numbers<S>& of, const FrictionSteps& steps, const Given<S>& slip) {
  if (slip.isZero(0)) {
    return slip;
  }
  const Vector3<S> along = slip.stableNormalized();
  constexpr S of_solid_spheres = 7.0L / 2;
  switch (steps.response) {
    case FrictionResponse::along_slip:
      return -slip / along.dot(of.k * along);
    case FrictionResponse::without_turning:
      return -slip / of.inverse_mass;
    case FrictionResponse::of_solid_spheres:
      return -slip / (of_solid_spheres * of.inverse_mass);
    case FrictionResponse::of_read_slip: {
      // If friction increases this slip, it never ends.
      constexpr S endless = 0x1p-200L;
      const S response = of.inverse_mass + of.read_spin * along.dot(of.by_turning * along);
      return -slip / std::max(response, endless * of.inverse_mass);
    }
    case FrictionResponse::by_matrix:
      break;
  }
  const auto [first, second] = tangents_of(of, Tangents::of_least_axis);
  Eigen::Matrix<S, 3, 2> basis;
  basis << first, second;
  const Eigen::Matrix<S, 2, 2> matrix = basis.transpose() * of.k * basis;
  return -basis * (matrix.inverse() * (basis.transpose() * slip));
}

/// With this tangential impulse, the normal impulse that gives N·V its rebound.
template <class S>
Vector3<S> with_normal_part(const Numbers<S>& of, const Given<S>& tangential) {
  const S along = (rebound(of) - of.normal.dot(of.k * tangential)) / of.normal.dot(of.k * of.normal);
  return of.normal * along + tangential;
}

/// The impulse along this vector that gives N·V its rebound.
template <class S>
Vector3<S> along_direction(const Numbers<S>& of, const Given<S>& direction) {
  return direction * (rebound(of) / of.normal.dot(of.k * direction));
}

template <class S>
Vector3<S> solved(const Numbers<S>& of, const Given<S>& change) {
  return of.k.partialPivLu().solve(change);
}

/// The answers of `coulomb` that slip are the zeros ν > 0 of ‖F_T‖ − μ F_n, with (K + ν P) F = b
/// (oracles/truths/coulomb.hpp). Without the normal part, (S + ν) F_T = c.
template <class S>
class CoulombSearch {
 public:
  CoulombSearch(const Numbers<S>& of, const Given<S>& slip) : friction_(of.friction) {
    const auto [first, second] = tangents_of(of, Tangents::of_least_axis);
    basis_ << of.normal, first, second;
    const Matrix3<S> k = basis_.transpose() * of.k * basis_;
    const Vector3<S> change = basis_.transpose() * Vector3<S>(of.normal * rebound(of) - slip);
    normal_ = change[0] / k(0, 0);
    coupling_ = k.row(0).template tail<2>().transpose() / k(0, 0);
    matrix_ = k.template bottomRightCorner<2, 2>() - k.col(0).template tail<2>() * coupling_.transpose();
    change_ = change.template tail<2>() - k.col(0).template tail<2>() * normal_;
  }

  /// No value if there are several answers.
  [[nodiscard]] std::optional<Vector3<S>> only_answer() const {
    const S half_trace = matrix_.trace() / 2;
    const S determinant = matrix_.determinant();
    const S greatest = half_trace + std::sqrt(std::max<S>(0, half_trace * half_trace - determinant));
    const S least = determinant / greatest;
    if (!(least > 0)) {
      return std::nullopt;
    }
    const bool is_monotone = oracles::friction_feedback<S>(friction_, coupling_.norm(), least, greatest) < 1;
    const bool sticks = excess(0) <= 0;
    S from = 0;
    S to = 0;
    int changes = 0;
    constexpr int most_steps = 400;
    const S growth = is_monotone ? 2 : std::sqrt(std::sqrt(S{2}));
    S next = least / 256;
    S last = 0;
    bool is_above = !sticks;
    for (int i = 0; i < most_steps && (is_monotone ? is_above : next < 256 * greatest || is_above); ++i) {
      if (const bool above = excess(next) > 0; above != is_above) {
        ++changes;
        from = last;
        to = next;
        is_above = above;
      }
      last = next;
      next *= growth;
    }
    if (is_above || changes + (sticks ? 1 : 0) != 1) {
      return std::nullopt;
    }
    return sticks ? impulse(0) : impulse(zero_between(from, to));
  }

  [[nodiscard]] const Matrix3<S>& basis() const { return basis_; }

 private:
  using Vector2 = Eigen::Matrix<S, 2, 1>;
  using Matrix2 = Eigen::Matrix<S, 2, 2>;

  [[nodiscard]] Vector2 tangential(S resistance) const {
    const S a = matrix_(0, 0) + resistance;
    const S d = matrix_(1, 1) + resistance;
    const S determinant = a * d - matrix_(0, 1) * matrix_(1, 0);
    return Vector2(d * change_[0] - matrix_(0, 1) * change_[1], a * change_[1] - matrix_(1, 0) * change_[0]) /
           determinant;
  }

  [[nodiscard]] S excess(S resistance) const {
    const Vector2 f = tangential(resistance);
    return f.norm() - friction_ * (normal_ - coupling_.dot(f));
  }

  [[nodiscard]] S zero_between(S above, S below) const {
    constexpr int most_halvings = 80;
    for (int i = 0; i < most_halvings; ++i) {
      const S middle = above + (below - above) / 2;
      (excess(middle) > 0 ? above : below) = middle;
    }
    return below;
  }

  [[nodiscard]] Vector3<S> impulse(S resistance) const {
    const Vector2 f = tangential(resistance);
    return basis_ * Vector3<S>(normal_ - coupling_.dot(f), f[0], f[1]);
  }

  S friction_;
  Matrix3<S> basis_;
  S normal_ = 0;
  Vector2 coupling_;
  Matrix2 matrix_;
  Vector2 change_;
};

template <class S>
std::optional<Vector3<S>> rough_together(const Numbers<S>& of, const FrictionSteps& steps, const Given<S>& slip) {
  const Vector3<S> stops_approach = of.normal * (-of.approach / of.normal.dot(of.k * of.normal));
  const Vector3<S> whole_normal = of.normal * frictionless(of);
  Vector3<S> d = solved(of, -(slip + of.normal * of.approach)) - stops_approach;
  if (steps.order == FrictionOrder::along_slip) {
    const Vector3<S> left = across(of, slip + of.k * stops_approach);
    d = left.isZero(0) ? d : Vector3<S>(-left * (across(of, d).norm() / left.norm()));
  }
  if (steps.order == FrictionOrder::apart_from_normal) {
    d = across(of, d);
  }
  const S whole = 1 + of.tangential_restitution;
  const S limit = of.friction * frictionless(of);
  if (steps.limit == FrictionLimit::box || steps.limit == FrictionLimit::pyramid) {
    return whole_normal + *limited(of, steps, across(of, whole * d), limit);
  }
  const S divisor = across(of, d).norm() - of.friction * of.normal.dot(d);
  const bool is_limited =
      steps.limit == FrictionLimit::always || (steps.limit == FrictionLimit::cone && whole * divisor > limit);
  if (is_limited && !(divisor > 0)) {
    return std::nullopt;
  }
  return Vector3<S>(whole_normal + d * (is_limited ? limit / divisor : whole));
}

template <class S>
std::optional<Vector3<S>> coulomb_together(const Numbers<S>& of, const FrictionSteps& steps, const Given<S>& slip) {
  if (of.friction == 0) {
    return Vector3<S>(of.normal * frictionless(of));
  }
  const Vector3<S> sticking = solved(of, of.normal * rebound(of) - slip);
  const S along = of.normal.dot(sticking);
  const Vector3<S> tangential = across(of, sticking);
  const bool sticks = tangential.norm() <= of.friction * along;
  switch (steps.limit) {
    case FrictionLimit::none:
      return sticking;
    case FrictionLimit::always:
      if (slip.isZero(0)) {
        return std::nullopt;
      }
      return along_direction(of, of.normal - slip.stableNormalized() * of.friction);
    case FrictionLimit::box:
    case FrictionLimit::pyramid:
      return sticks ? sticking : with_normal_part(of, *limited(of, steps, tangential, of.friction * std::abs(along)));
    case FrictionLimit::cone:
      break;
  }
  if (steps.order == FrictionOrder::apart_from_normal) {
    const S normal = frictionless(of);
    return Vector3<S>(of.normal * normal + *limited(of, steps, tangential, of.friction * normal));
  }
  if (steps.order == FrictionOrder::together) {
    return CoulombSearch(of, slip).only_answer();
  }
  const Vector3<S> direction = steps.order == FrictionOrder::along_slip ? Vector3<S>(-slip) : tangential;
  if (sticks || direction.isZero(0)) {
    return sticking;
  }
  return along_direction(of, of.normal + direction.stableNormalized() * of.friction);
}

template <class S>
std::optional<Vector3<S>> together(const Numbers<S>& of, Law law, const FrictionSteps& steps) {
  Vector3<S> slip = of.slip * static_cast<S>(steps.stopped);
  if (steps.response == FrictionResponse::without_turning || steps.response == FrictionResponse::of_solid_spheres) {
    slip = -across(of, of.k * stopping(of, steps, slip));
  }
  switch (law) {
    case Law::frictionless:
      return Vector3<S>(of.normal * frictionless(of));
    case Law::reflection:
      return solved(of, of.normal * rebound(of));
    case Law::sticking:
      if (steps.order == FrictionOrder::apart_from_normal) {
        return Vector3<S>(of.normal * frictionless(of) + across(of, solved(of, of.normal * rebound(of) - slip)));
      }
      return solved(of, of.normal * rebound(of) - slip);
    case Law::rough:
      return of.friction == 0 ? Vector3<S>(of.normal * frictionless(of)) : rough_together(of, steps, slip);
    case Law::coulomb:
      return coulomb_together(of, steps, slip);
    case Law::any:
      break;
  }
  return std::nullopt;
}

/// The impulse of a solver that computes friction once.
template <class S>
std::optional<Vector3<S>> in_one_pass(const Numbers<S>& of, Law law, FrictionSteps steps) {
  const S normal = frictionless(of);
  Vector3<S> slip = of.slip;
  if (steps.order == FrictionOrder::after_normal) {
    slip += across(of, of.k * of.normal * normal);
  }
  if (law == Law::sticking) {
    steps.limit = FrictionLimit::none;
  }
  const S share = static_cast<S>(steps.stopped) * (law == Law::rough ? 1 + of.tangential_restitution : 1);
  const std::optional<Vector3<S>> tangential =
      limited(of, steps, stopping(of, steps, slip) * share, of.friction * normal);
  if (!tangential) {
    return std::nullopt;
  }
  if (steps.order == FrictionOrder::before_normal) {
    return with_normal_part(of, *tangential);
  }
  if (steps.order == FrictionOrder::before_approach) {
    const S approach = of.approach + of.normal.dot(of.k * *tangential);
    return Vector3<S>(*tangential + of.normal * (-(1 + of.restitution) * approach / of.normal.dot(of.k * of.normal)));
  }
  return Vector3<S>(*tangential + of.normal * normal);
}

}  // namespace

Matrix3<long double> inverse_inertia(const BasicBody<long double>& body) { return right_inverse_inertia(body); }

bool has_friction(Law law) { return law == Law::sticking || law == Law::rough || law == Law::coulomb; }

std::optional<Vector3<double>> impulse_by(const Collision& collision, Law law, const FrictionSteps& steps,
                                          const MatrixSteps& matrix) {
  CAROM_EXPECTS(has_movable_body(collision));
  const auto impulse_in = [&]<class S>(S) -> std::optional<Vector3<double>> {
    const Numbers<S> of = numbers_of<S>(collision, steps, matrix);
    const bool is_of_one_pass =
        steps.order == FrictionOrder::after_normal || steps.order == FrictionOrder::of_slip_before ||
        steps.order == FrictionOrder::before_normal || steps.order == FrictionOrder::before_approach;
    const std::optional<Vector3<S>> impulse =
        is_of_one_pass && has_friction(law) ? in_one_pass(of, law, steps) : together(of, law, steps);
    return impulse && impulse->allFinite() ? std::optional(Vector3<double>(impulse->template cast<double>()))
                                           : std::nullopt;
  };
  return suffices_binary64(collision) ? impulse_in(double{}) : impulse_in(Wide{});
}

}  // namespace carom::properties::diagnosis
