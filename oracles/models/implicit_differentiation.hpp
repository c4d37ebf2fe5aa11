// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/LU>

#include <carom/oracles/models/superposition.hpp>
#include <carom/oracles/numbers/inputs.hpp>

/// Implicit differentiation of a law's answer, in binary64: the impulse F solves K F = b, so K dF = db − dK F, and what
/// bodies answer is linear in F, so that only the answer to one impulse, held fast, is differentiated, body by body.
namespace carom::oracles {

/// The derivatives of a vector by all numbers of a collision.
using Jacobian = Eigen::Matrix<double, 3, collision_inputs, Eigen::RowMajor>;

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
  [[nodiscard]] Eigen::Index restitution() const { return normal + 3; }
  [[nodiscard]] Eigen::Index friction() const { return normal + 4; }
  [[nodiscard]] Eigen::Index tangential_restitution() const { return normal + 5; }
  std::vector<Quantity> quantities;

  explicit Places(const Collision& collision) {
    const auto numbers_of = [](const Body& body) { return body.immovable ? 9 : 17; };
    constexpr Eigen::Index after_position = 9;
    a.position = numbers_of(collision.a) - after_position;
    b.position = numbers_of(collision.a) + numbers_of(collision.b) - after_position;
    point = b.position + after_position;
    normal = point + 3;
    quantities = quantities_of(collision);
  }
};

template <std::size_t N>
[[nodiscard]] Vector3<Dual<double, N>> inputs(const Vector3<double>& numbers, std::size_t first) {
  Vector3<Dual<double, N>> result;
  for (int i = 0; i < 3; ++i) {
    result[i] = Dual<double, N>::input(numbers[i], first + static_cast<std::size_t>(i));
  }
  return result;
}

template <std::size_t N>
[[nodiscard]] Vector3<double> value(const Vector3<Dual<double, N>>& numbers) {
  return {numbers[0].value, numbers[1].value, numbers[2].value};
}

/// The derivatives by `Count` inputs from this one on.
template <int Count, std::size_t N>
[[nodiscard]] Eigen::Matrix<double, 3, Count> derivatives(const Vector3<Dual<double, N>>& numbers, std::size_t first) {
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

[[nodiscard]] inline BodyResponse response_of(const Body& body, const Vector3<double>& point,
                                              const Vector3<double>& impulse, const Places::OfBody& place,
                                              Eigen::Index point_place) {
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

/// The derivatives of an impulse, and of what it adds to each of the four velocities.
struct Derivatives {
  Jacobian of_impulse;
  PerVector<Jacobian> of_change;
};

/// What is differentiated: the responses of both bodies to the impulse F on A and −F on B.
struct ImpulseDifferential {
  BodyResponse a;
  BodyResponse b;
  Vector3<double> impulse;
  Vector3<double> wanted;   // b, the change of relative velocity that the law asks for
  Jacobian left;            // dK F − db
  Eigen::Index normal = 0;  // where the normal stands among the inputs
};

/// Of a law whose impulse satisfies K F = b: dF = K⁻¹ (db − dK F).
[[nodiscard]] inline Derivatives derivatives_by_matrix(const ImpulseDifferential& of) {
  const Jacobian d_impulse = -(of.a.at_point + of.b.at_point).inverse() * of.left;
  return {d_impulse,
          {of.a.d_velocity + of.a.velocity * d_impulse, of.a.d_angular_velocity + of.a.angular_velocity * d_impulse,
           of.b.d_velocity - of.b.velocity * d_impulse, of.b.d_angular_velocity - of.b.angular_velocity * d_impulse}};
}

}  // namespace carom::oracles
