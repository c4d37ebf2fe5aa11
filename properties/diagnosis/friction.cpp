// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include <carom/collision/expects.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/truths/coulomb.hpp>
#include <carom/properties/diagnosis/friction.hpp>

namespace carom::properties::diagnosis {
namespace {

using Wide = long double;
using Vector = Vector3<Wide>;
using Matrix = Matrix3<Wide>;

/// The numbers of a contact that a solver uses.
struct Numbers {
  Matrix k = Matrix::Zero();
  Matrix by_turning = Matrix::Zero();  // K − λI
  Wide inverse_mass = 0;               // λ
  Vector normal;                       // of length 1
  Wide approach = 0;                   // N·V⁻ / ‖N‖
  Vector slip;
  Wide read_spin = 1;  // the factor of the spins in the slip
  Wide restitution = 0;
  Wide friction = 0;
  Wide tangential_restitution = 0;
};

Vector across(const Numbers& of, const Vector& v) { return v - of.normal * of.normal.dot(v); }

Matrix cross_matrix(const Vector& r) {
  Matrix matrix;
  matrix << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  return matrix;
}

Numbers numbers_of(const Collision& collision, const FrictionSteps& steps, const MatrixSteps& matrix) {
  const BasicCollision<Wide> c = map_numbers<Wide>(collision, [](double x) { return static_cast<Wide>(x); });
  Numbers of;
  of.normal = c.normal.stableNormalized();
  Vector by_spins = Vector::Zero();
  Vector by_read_spins = Vector::Zero();
  for (const auto* body : {&c.a, &c.b}) {
    const Wide sign = body == &c.a ? 1 : -1;
    const auto factor = static_cast<Wide>(body == &c.a ? steps.spin_of_a : steps.spin_of_b);
    const Vector arm = oracles::lever_arm(*body, c.point);
    const Vector read = steps.has_arms_of_length_1 ? Vector(arm.stableNormalized()) : arm;
    by_spins += sign * body->angular_velocity.cross(arm);
    by_read_spins += sign * factor * body->angular_velocity.cross(read);
    if (!body->immovable) {
      of.inverse_mass += 1 / body->mass;
      const Matrix r = cross_matrix(arm);
      of.by_turning -= r * (body == &c.a ? matrix.inverse_of_a : matrix.inverse_of_b)(*body) * r;
    }
  }
  of.k = of.by_turning + Matrix::Identity() * (of.inverse_mass + static_cast<Wide>(matrix.added));
  if (matrix.is_diagonal) {
    of.k = Matrix(of.k.diagonal().asDiagonal());
  }
  of.read_spin = static_cast<Wide>(steps.spin_of_a == 1 ? steps.spin_of_b : steps.spin_of_a);
  const Vector of_centres = c.a.velocity - c.b.velocity;
  of.approach = of.normal.dot(of_centres + by_spins);
  of.slip = across(of, of_centres + by_read_spins);
  of.restitution = c.restitution;
  of.friction = c.friction;
  of.tangential_restitution = c.tangential_restitution;
  return of;
}

/// N·V⁺ − N·V⁻ by restitution, with N of length 1.
Wide rebound(const Numbers& of) { return -(1 + of.restitution) * of.approach; }

Wide frictionless(const Numbers& of) { return rebound(of) / of.normal.dot(of.k * of.normal); }

/// Two tangents of length 1.
std::pair<Vector, Vector> tangents_of(const Numbers& of, Tangents tangents) {
  const Vector& n = of.normal;
  const auto with = [&](const Vector& first) {
    const Vector t = first.normalized();
    return std::pair(t, Vector(n.cross(t)));
  };
  switch (tangents) {
    case Tangents::beside_normal:
      return with(std::abs(n[0]) < std::abs(n[2]) ? Vector(0, -n[2], n[1]) : Vector(-n[1], n[0], 0));
    case Tangents::of_least_axis: {
      int axis = 0;
      n.cwiseAbs().minCoeff(&axis);
      return with(across(of, Vector::Unit(axis)));
    }
    case Tangents::branchless: {
      const Wide sign = std::copysign(Wide{1}, n[2]);
      const Wide a = -1 / (sign + n[2]);
      return with({1 + sign * n[0] * n[0] * a, sign * n[0] * n[1] * a, -sign * n[0]});
    }
    case Tangents::of_slip:
      break;
  }
  return of.slip.isZero(0) ? tangents_of(of, Tangents::of_least_axis) : with(of.slip);
}

/// A tangential impulse within a limit. No value if its direction is not known.
std::optional<Vector> limited(const Numbers& of, const FrictionSteps& steps, const Vector& impulse, Wide limit) {
  const Wide length = impulse.stableNorm();
  switch (steps.limit) {
    case FrictionLimit::cone:
      return length > limit ? Vector(impulse * (limit / length)) : impulse;
    case FrictionLimit::none:
      return impulse;
    case FrictionLimit::always:
      return length > 0 ? std::optional(Vector(impulse * (limit / length))) : std::nullopt;
    case FrictionLimit::box:
    case FrictionLimit::pyramid:
      break;
  }
  const auto [first, second] = tangents_of(of, steps.tangents);
  Wide x = impulse.dot(first);
  Wide y = impulse.dot(second);
  if (steps.limit == FrictionLimit::box) {
    x = std::clamp(x, -limit, limit);
    y = std::clamp(y, -limit, limit);
  } else {
    const Wide share = std::min<Wide>(1, limit / std::max(std::abs(x) + std::abs(y), limit));
    x *= share;
    y *= share;
  }
  return Vector(first * x + second * y);
}

/// The tangential impulse that stops this slip, in a solver of one pass.
Vector stopping(const Numbers& of, const FrictionSteps& steps, const Vector& slip) {
  if (slip.isZero(0)) {
    return slip;
  }
  const Vector along = slip.stableNormalized();
  constexpr Wide of_solid_spheres = 7.0L / 2;
  switch (steps.response) {
    case FrictionResponse::along_slip:
      return -slip / along.dot(of.k * along);
    case FrictionResponse::without_turning:
      return -slip / of.inverse_mass;
    case FrictionResponse::of_solid_spheres:
      return -slip / (of_solid_spheres * of.inverse_mass);
    case FrictionResponse::of_read_slip: {
      // If friction increases this slip, it never ends.
      constexpr Wide endless = 0x1p-200L;
      const Wide response = of.inverse_mass + of.read_spin * along.dot(of.by_turning * along);
      return -slip / std::max(response, endless * of.inverse_mass);
    }
    case FrictionResponse::by_matrix:
      break;
  }
  const auto [first, second] = tangents_of(of, Tangents::of_least_axis);
  Eigen::Matrix<Wide, 3, 2> basis;
  basis << first, second;
  const Eigen::Matrix<Wide, 2, 2> matrix = basis.transpose() * of.k * basis;
  return -basis * (matrix.inverse() * (basis.transpose() * slip));
}

/// With this tangential impulse, the normal impulse that gives N·V its rebound.
Vector with_normal_part(const Numbers& of, const Vector& tangential) {
  const Wide along = (rebound(of) - of.normal.dot(of.k * tangential)) / of.normal.dot(of.k * of.normal);
  return of.normal * along + tangential;
}

/// The impulse along this vector that gives N·V its rebound.
Vector along_direction(const Numbers& of, const Vector& direction) {
  return direction * (rebound(of) / of.normal.dot(of.k * direction));
}

Vector solved(const Numbers& of, const Vector& change) { return of.k.partialPivLu().solve(change); }

/// The answers of `coulomb` that slip are the zeros ν > 0 of ‖F_T‖ − μ F_n, with (K + ν P) F = b
/// (oracles/truths/coulomb.hpp). Without the normal part, (S + ν) F_T = c.
class CoulombSearch {
 public:
  CoulombSearch(const Numbers& of, const Vector& slip) : friction_(of.friction) {
    const auto [first, second] = tangents_of(of, Tangents::of_least_axis);
    basis_ << of.normal, first, second;
    const Matrix k = basis_.transpose() * of.k * basis_;
    const Vector change = basis_.transpose() * Vector(of.normal * rebound(of) - slip);
    normal_ = change[0] / k(0, 0);
    coupling_ = k.row(0).tail<2>().transpose() / k(0, 0);
    matrix_ = k.bottomRightCorner<2, 2>() - k.col(0).tail<2>() * coupling_.transpose();
    change_ = change.tail<2>() - k.col(0).tail<2>() * normal_;
  }

  /// No value if there are several answers.
  [[nodiscard]] std::optional<Vector> only_answer() const {
    const Wide half_trace = matrix_.trace() / 2;
    const Wide determinant = matrix_.determinant();
    const Wide greatest = half_trace + std::sqrt(std::max<Wide>(0, half_trace * half_trace - determinant));
    const Wide least = determinant / greatest;
    if (!(least > 0)) {
      return std::nullopt;
    }
    const bool is_monotone = oracles::friction_feedback<Wide>(friction_, coupling_.norm(), least, greatest) < 1;
    const bool sticks = excess(0) <= 0;
    Wide from = 0;
    Wide to = 0;
    int changes = 0;
    constexpr int most_steps = 400;
    const Wide growth = is_monotone ? 2 : std::sqrt(std::sqrt(Wide{2}));
    Wide next = least / 256;
    Wide last = 0;
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

  [[nodiscard]] const Matrix& basis() const { return basis_; }

 private:
  using Vector2 = Eigen::Matrix<Wide, 2, 1>;
  using Matrix2 = Eigen::Matrix<Wide, 2, 2>;

  [[nodiscard]] Vector2 tangential(Wide resistance) const {
    const Wide a = matrix_(0, 0) + resistance;
    const Wide d = matrix_(1, 1) + resistance;
    const Wide determinant = a * d - matrix_(0, 1) * matrix_(1, 0);
    return Vector2(d * change_[0] - matrix_(0, 1) * change_[1], a * change_[1] - matrix_(1, 0) * change_[0]) /
           determinant;
  }

  [[nodiscard]] Wide excess(Wide resistance) const {
    const Vector2 f = tangential(resistance);
    return f.norm() - friction_ * (normal_ - coupling_.dot(f));
  }

  [[nodiscard]] Wide zero_between(Wide above, Wide below) const {
    constexpr int most_halvings = 80;
    for (int i = 0; i < most_halvings; ++i) {
      const Wide middle = above + (below - above) / 2;
      (excess(middle) > 0 ? above : below) = middle;
    }
    return below;
  }

  [[nodiscard]] Vector impulse(Wide resistance) const {
    const Vector2 f = tangential(resistance);
    return basis_ * Vector(normal_ - coupling_.dot(f), f[0], f[1]);
  }

  Wide friction_;
  Matrix basis_;
  Wide normal_ = 0;
  Vector2 coupling_;
  Matrix2 matrix_;
  Vector2 change_;
};

std::optional<Vector> rough_together(const Numbers& of, const FrictionSteps& steps, const Vector& slip) {
  const Vector stops_approach = of.normal * (-of.approach / of.normal.dot(of.k * of.normal));
  const Vector whole_normal = of.normal * frictionless(of);
  Vector d = solved(of, -(slip + of.normal * of.approach)) - stops_approach;
  if (steps.order == FrictionOrder::along_slip) {
    const Vector left = across(of, slip + of.k * stops_approach);
    d = left.isZero(0) ? d : Vector(-left * (across(of, d).norm() / left.norm()));
  }
  if (steps.order == FrictionOrder::apart_from_normal) {
    d = across(of, d);
  }
  const Wide whole = 1 + of.tangential_restitution;
  const Wide limit = of.friction * frictionless(of);
  if (steps.limit == FrictionLimit::box || steps.limit == FrictionLimit::pyramid) {
    return whole_normal + *limited(of, steps, across(of, whole * d), limit);
  }
  const Wide divisor = across(of, d).norm() - of.friction * of.normal.dot(d);
  const bool is_limited =
      steps.limit == FrictionLimit::always || (steps.limit == FrictionLimit::cone && whole * divisor > limit);
  if (is_limited && !(divisor > 0)) {
    return std::nullopt;
  }
  return Vector(whole_normal + d * (is_limited ? limit / divisor : whole));
}

std::optional<Vector> coulomb_together(const Numbers& of, const FrictionSteps& steps, const Vector& slip) {
  if (of.friction == 0) {
    return Vector(of.normal * frictionless(of));
  }
  const Vector sticking = solved(of, of.normal * rebound(of) - slip);
  const Wide along = of.normal.dot(sticking);
  const Vector tangential = across(of, sticking);
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
    const Wide normal = frictionless(of);
    return Vector(of.normal * normal + *limited(of, steps, tangential, of.friction * normal));
  }
  if (steps.order == FrictionOrder::together) {
    return CoulombSearch(of, slip).only_answer();
  }
  const Vector direction = steps.order == FrictionOrder::along_slip ? Vector(-slip) : tangential;
  if (sticks || direction.isZero(0)) {
    return sticking;
  }
  return along_direction(of, of.normal + direction.stableNormalized() * of.friction);
}

std::optional<Vector> together(const Numbers& of, Law law, const FrictionSteps& steps) {
  Vector slip = of.slip * static_cast<Wide>(steps.stopped);
  if (steps.response == FrictionResponse::without_turning || steps.response == FrictionResponse::of_solid_spheres) {
    slip = -across(of, of.k * stopping(of, steps, slip));
  }
  switch (law) {
    case Law::frictionless:
      return Vector(of.normal * frictionless(of));
    case Law::reflection:
      return solved(of, of.normal * rebound(of));
    case Law::sticking:
      if (steps.order == FrictionOrder::apart_from_normal) {
        return Vector(of.normal * frictionless(of) + across(of, solved(of, of.normal * rebound(of) - slip)));
      }
      return solved(of, of.normal * rebound(of) - slip);
    case Law::rough:
      return of.friction == 0 ? Vector(of.normal * frictionless(of)) : rough_together(of, steps, slip);
    case Law::coulomb:
      return coulomb_together(of, steps, slip);
    case Law::any:
      break;
  }
  return std::nullopt;
}

/// The impulse of a solver that computes friction once.
std::optional<Vector> in_one_pass(const Numbers& of, Law law, FrictionSteps steps) {
  const Wide normal = frictionless(of);
  Vector slip = of.slip;
  if (steps.order == FrictionOrder::after_normal) {
    slip += across(of, of.k * of.normal * normal);
  }
  if (law == Law::sticking) {
    steps.limit = FrictionLimit::none;
  }
  const Wide share = static_cast<Wide>(steps.stopped) * (law == Law::rough ? 1 + of.tangential_restitution : 1);
  const std::optional<Vector> tangential = limited(of, steps, stopping(of, steps, slip) * share, of.friction * normal);
  if (!tangential) {
    return std::nullopt;
  }
  if (steps.order == FrictionOrder::before_normal) {
    return with_normal_part(of, *tangential);
  }
  if (steps.order == FrictionOrder::before_approach) {
    const Wide approach = of.approach + of.normal.dot(of.k * *tangential);
    return Vector(*tangential + of.normal * (-(1 + of.restitution) * approach / of.normal.dot(of.k * of.normal)));
  }
  return Vector(*tangential + of.normal * normal);
}

}  // namespace

Matrix3<long double> inverse_inertia(const BasicBody<long double>& body) {
  Matrix axes;
  for (int i = 0; i < 3; ++i) {
    axes.col(i) = oracles::turned<Wide>(body.orientation, Vector::Unit(i));
  }
  return axes * body.principal_inertia.cwiseInverse().asDiagonal() * axes.transpose();
}

bool has_friction(Law law) { return law == Law::sticking || law == Law::rough || law == Law::coulomb; }

std::optional<Vector3<double>> impulse_by(const Collision& collision, Law law, const FrictionSteps& steps,
                                          const MatrixSteps& matrix) {
  CAROM_EXPECTS(has_movable_body(collision));
  const Numbers of = numbers_of(collision, steps, matrix);
  const bool is_of_one_pass =
      steps.order == FrictionOrder::after_normal || steps.order == FrictionOrder::of_slip_before ||
      steps.order == FrictionOrder::before_normal || steps.order == FrictionOrder::before_approach;
  const std::optional<Vector> impulse =
      is_of_one_pass && has_friction(law) ? in_one_pass(of, law, steps) : together(of, law, steps);
  return impulse && impulse->allFinite() ? std::optional(Vector3<double>(impulse->cast<double>())) : std::nullopt;
}

}  // namespace carom::properties::diagnosis
