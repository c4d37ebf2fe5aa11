// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/models/sensitivity.hpp>
#include <carom/oracles/models/superposition.hpp>
#include <carom/oracles/numbers/inputs.hpp>
#include <carom/oracles/numbers/norm.hpp>

namespace carom::oracles {
namespace {

/// The derivatives of a vector by all numbers of a collision.
using Jacobian = Eigen::Matrix<double, 3, collision_inputs, Eigen::RowMajor>;
using Magnitudes = Eigen::Array<double, 1, collision_inputs>;

/// Where the numbers of a collision stand among its inputs.
struct Places {
  struct OfBody {
    Eigen::Index position = 0;  // behind mass, principal inertia and orientation, where the body has them
    [[nodiscard]] Eigen::Index velocity() const { return position + 3; }
    [[nodiscard]] Eigen::Index angular_velocity() const { return position + 6; }
  };
  OfBody a;
  OfBody b;
  Eigen::Index point = 0;
  Eigen::Index normal = 0;
  Magnitudes magnitude = Magnitudes::Zero();  // |x_j|

  explicit Places(const Collision& collision) {
    const auto numbers_of = [](const Body& body) { return body.immovable ? 9 : 17; };
    constexpr Eigen::Index after_position = 9;
    a.position = numbers_of(collision.a) - after_position;
    b.position = numbers_of(collision.a) + numbers_of(collision.b) - after_position;
    point = b.position + after_position;
    normal = point + 3;
    Eigen::Index next = 0;
    for_each_number([&](const FieldPath&, const double& x) { magnitude[next++] = std::abs(x); }, collision);
  }
};

template <std::size_t N>
Vector3<Dual<double, N>> inputs(const Vector3<double>& numbers, std::size_t first) {
  Vector3<Dual<double, N>> result;
  for (int i = 0; i < 3; ++i) {
    result[i] = Dual<double, N>::input(numbers[i], first + static_cast<std::size_t>(i));
  }
  return result;
}

template <std::size_t N>
Vector3<double> value(const Vector3<Dual<double, N>>& numbers) {
  return {numbers[0].value, numbers[1].value, numbers[2].value};
}

/// The derivatives by `Count` inputs from this one on.
template <int Count, std::size_t N>
Eigen::Matrix<double, 3, Count> derivatives(const Vector3<Dual<double, N>>& numbers, std::size_t first) {
  Eigen::Matrix<double, 3, Count> result;
  for (int i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < Count; ++j) {
      result(i, static_cast<Eigen::Index>(j)) = numbers[i].derivative[first + j];
    }
  }
  return result;
}

/// How one body answers to impulses at the contact point: not at all where it is immovable.
struct BodyResponse {
  // Columns: the answers to unit impulses.
  Matrix3<double> velocity = Matrix3<double>::Zero();
  Matrix3<double> angular_velocity = Matrix3<double>::Zero();
  Matrix3<double> at_point = Matrix3<double>::Zero();
  // The derivatives of the answer to the given impulse, which itself stays as it is.
  Jacobian d_velocity = Jacobian::Zero();
  Jacobian d_angular_velocity = Jacobian::Zero();
  Jacobian d_at_point = Jacobian::Zero();
};

BodyResponse response_of(const Body& body, const Vector3<double>& point, const Vector3<double>& impulse,
                         const Places::OfBody& place, Eigen::Index point_place) {
  BodyResponse result;
  if (body.immovable) {
    return result;
  }
  const Vector3<double> arm = lever_arm(body, point);
  for (int i = 0; i < 3; ++i) {
    const BodyVelocity<double> answer = response<double>(body, point, Vector3<double>::Unit(i));
    result.velocity.col(i) = answer.velocity;
    result.angular_velocity.col(i) = answer.angular_velocity;
    result.at_point.col(i) = point_velocity<double>(answer, arm);
  }
  // Mass, three moments, four numbers of the orientation and three of the position; three of the contact point.
  constexpr int own = 11;
  using T = Dual<double, own + 3>;
  BasicBody<T> dual;
  std::size_t next = 0;
  auto as_input = [&](const FieldPath&, const double& from, T& to) {
    to = next < own ? T::input(from, next) : T(from);
    ++next;
  };
  carom::detail::for_each_body_number("", as_input, body, dual);
  const Vector3<T> at = inputs<own + 3>(point, own);
  const BodyVelocity<T> answer = response<T>(dual, at, impulse.unaryExpr([](double x) { return T(x); }));
  const auto spread = [&](const Vector3<T>& from, Jacobian& to) {
    to.middleCols<own>(place.velocity() - own) = derivatives<own>(from, 0);
    to.middleCols<3>(point_place) = derivatives<3>(from, own);
  };
  spread(answer.velocity, result.d_velocity);
  spread(answer.angular_velocity, result.d_angular_velocity);
  spread(point_velocity<T>(answer, lever_arm<T>(dual, at)), result.d_at_point);
  return result;
}

/// The change that the law asks for, and its derivatives.
struct Wanted {
  Vector3<double> change;
  Jacobian derivative = Jacobian::Zero();
};

/// By the chain rule through the relative velocity before the impulse.
Wanted wanted_of(const Collision& c, const Places& places) {
  Wanted result;
  Jacobian d_velocity = Jacobian::Zero();
  Vector3<double> velocity{0, 0, 0};
  const auto add_body = [&](const Body& body, const Places::OfBody& place, double sign) {
    constexpr std::size_t own = 9;  // position, velocity, angular velocity; and the contact point
    using T = Dual<double, own + 3>;
    const Vector3<T> arm = inputs<own + 3>(c.point, own) - inputs<own + 3>(body.position, 0);
    const Vector3<T> at_point =
        point_velocity<T>({inputs<own + 3>(body.velocity, 3), inputs<own + 3>(body.angular_velocity, 6)}, arm);
    velocity += sign * value(at_point);
    d_velocity.middleCols<own>(place.position) += sign * derivatives<own>(at_point, 0);
    d_velocity.middleCols<3>(places.point) += sign * derivatives<3>(at_point, own);
  };
  add_body(c.a, places.a, 1);
  add_body(c.b, places.b, -1);
  using T = Dual<double, 7>;  // normal, restitution, relative velocity
  const Vector3<T> wanted =
      wanted_change<T>(inputs<7>(c.normal, 0), T::input(c.restitution, 3), inputs<7>(velocity, 4));
  result.change = value(wanted);
  result.derivative = derivatives<3>(wanted, 4) * d_velocity;
  result.derivative.middleCols<4>(places.normal) += derivatives<4>(wanted, 0);
  return result;
}

using Row = Eigen::Matrix<double, 1, collision_inputs>;

/// The derivatives of what the impulse adds to each of the four velocities.
using Derivatives = std::array<Jacobian, 4>;

/// F satisfies K F = b, so dF = K⁻¹ (db − dK F). `left` is dK F − db at that impulse.
Derivatives derivatives_of_reflection(const BodyResponse& a, const BodyResponse& b, const Jacobian& left) {
  const Jacobian d_impulse = -(a.at_point + b.at_point).inverse() * left;
  return {a.d_velocity + a.velocity * d_impulse, a.d_angular_velocity + a.angular_velocity * d_impulse,
          b.d_velocity - b.velocity * d_impulse, b.d_angular_velocity - b.angular_velocity * d_impulse};
}

/// F = φ N satisfies N·(K F − b) = 0, so dF = φ dN + N dφ. The answers to N are worked out as such: from the columns of
/// the matrices they would cancel where a lever arm is along N.
Derivatives derivatives_of_frictionless(const Collision& c, const BodyResponse& a, const BodyResponse& b,
                                        const Vector3<double>& impulse, const Vector3<double>& wanted,
                                        const Jacobian& left, Eigen::Index normal_place) {
  const Vector3<double>& n = c.normal;
  const double per_normal = n.dot(impulse) / n.dot(n);  // φ
  const Outcome<double> to_normal = response<double>(c, n);
  const Vector3<double> k_normal = relative_velocity<double>(c, to_normal);  // K N
  Row of_condition = n.transpose() * left;
  of_condition.segment<3>(normal_place) += (2 * per_normal * k_normal - wanted).transpose();
  const Row d_per_normal = of_condition / -n.dot(k_normal);
  Derivatives result{a.d_velocity + to_normal.a.velocity * d_per_normal,
                     a.d_angular_velocity + to_normal.a.angular_velocity * d_per_normal,
                     b.d_velocity + to_normal.b.velocity * d_per_normal,
                     b.d_angular_velocity + to_normal.b.angular_velocity * d_per_normal};
  result[0].middleCols<3>(normal_place) += per_normal * a.velocity;
  result[1].middleCols<3>(normal_place) += per_normal * a.angular_velocity;
  result[2].middleCols<3>(normal_place) -= per_normal * b.velocity;
  result[3].middleCols<3>(normal_place) -= per_normal * b.angular_velocity;
  return result;
}

/// Σ_j ‖∂y/∂x_j‖ |x_j|; not a number where squares may have left the range of binary64.
double weighted_norm(const Jacobian& jacobian, const Magnitudes& magnitude) {
  const double sum = (jacobian.array().square().colwise().sum().sqrt() * magnitude).sum();
  if (sum == 0 && (jacobian.array().abs().colwise().sum() * magnitude == 0).all()) {
    return 0;
  }
  return sum >= least_sum_by_squares && sum <= largest_sum_by_squares ? sum : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::array<double, 4> norms_before(const Collision& collision) { return norms_of(unchanged(collision)); }

std::optional<Sensitivity> colliding_sensitivity(const Collision& c, Model model) {
  const Places places(c);
  const Wanted wanted = wanted_of(c, places);
  const Vector3<double> impulse = impulse_for<double>(c, model, wanted.change);
  const BodyResponse a = response_of(c.a, c.point, impulse, places.a, places.point);
  const BodyResponse b = response_of(c.b, c.point, -impulse, places.b, places.point);
  const Jacobian left = a.d_at_point - b.d_at_point - wanted.derivative;
  Derivatives derivatives = model == Model::reflection
                                ? derivatives_of_reflection(a, b, left)
                                : derivatives_of_frictionless(c, a, b, impulse, wanted.change, left, places.normal);
  const std::array<Eigen::Index, 4> before{places.a.velocity(), places.a.angular_velocity(), places.b.velocity(),
                                           places.b.angular_velocity()};
  Sensitivity result = norms_before(c);
  for (std::size_t k = 0; k < result.size(); ++k) {
    derivatives[k].middleCols<3>(before[k]) += Matrix3<double>::Identity();
    result[k] += weighted_norm(derivatives[k], places.magnitude);
  }
  const bool is_known = std::all_of(result.begin(), result.end(), [](double sum) { return std::isfinite(sum); });
  return is_known ? std::optional<Sensitivity>(result) : std::nullopt;
}

std::optional<Sensitivity> enclosed_sensitivity(const Collision& collision, Model model) {
  using T = Dual<Enclosure, collision_inputs>;
  const auto inputs = dual_inputs<Enclosure, collision_inputs>(collision, [](double x) { return Enclosure(x); });
  const Truth<T> truth = colliding_truth(inputs.collision, model);
  Sensitivity result = norms_before(collision);
  const auto parts = vectors(truth.outcome);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    double unknown = 0;
    for (int i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < inputs.magnitude.size(); ++j) {
        const double radius = (*parts[k])[i].derivative[j].radius();
        unknown += inputs.magnitude[j] == 0 ? 0 : radius * inputs.magnitude[j];
      }
    }
    result[k] += sensitivity_of({&(*parts[k])[0], &(*parts[k])[1], &(*parts[k])[2]}, inputs.magnitude);
    // Written so that what is no number is not known.
    if (!(unknown <= ten_digits * result[k]) || !std::isfinite(result[k])) {
      return std::nullopt;
    }
  }
  return result;
}

Sensitivity exact_sensitivity(const Collision& collision, Model model) {
  const auto inputs = dual_inputs<Rational, collision_inputs>(collision, [](double x) { return Rational(x); });
  const auto truth = colliding_truth(inputs.collision, model);
  Sensitivity result = norms_before(collision);
  const auto parts = vectors(truth.outcome);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    result[k] += sensitivity_of({&(*parts[k])[0], &(*parts[k])[1], &(*parts[k])[2]}, inputs.magnitude);
  }
  return result;
}

}  // namespace carom::oracles
