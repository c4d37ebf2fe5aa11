// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <carom/collision/vector.hpp>
#include <carom/oracles/bounds/quantities.hpp>
#include <carom/oracles/truths/superposition.hpp>

/// Implicit differentiation of a law's answer. The impulse F solves K F = b, with b the change of relative velocity
/// that the law requires (`frictionless`: N·K F = N·b). So K dF = db − dK F. The term dK F is the derivative of the
/// response to a fixed impulse F. S is double or Enclosure.
namespace carom::oracles {

/// The derivatives of a vector with respect to all numbers of a collision.
template <class S>
using Jacobian = Eigen::Matrix<S, 3, collision_inputs, Eigen::RowMajor>;

struct InputIndices {
  struct OfBody {
    Eigen::Index position;  // after mass, principal inertia and orientation, if the body has them
    [[nodiscard]] Eigen::Index velocity() const { return position + 3; }
    [[nodiscard]] Eigen::Index angular_velocity() const { return position + 6; }
    [[nodiscard]] Eigen::Index next() const { return position + 9; }
  };
  OfBody a;
  OfBody b;
  std::vector<Quantity> quantities;

  explicit InputIndices(const Collision& collision)
      : a{inertia_numbers(collision.a)},
        b{a.next() + inertia_numbers(collision.b)},
        quantities(quantities_of(collision)) {}

  [[nodiscard]] Eigen::Index point() const { return b.next(); }
  [[nodiscard]] Eigen::Index normal() const { return point() + 3; }
  [[nodiscard]] Eigen::Index restitution() const { return normal() + 3; }
  [[nodiscard]] Eigen::Index friction() const { return normal() + 4; }
  [[nodiscard]] Eigen::Index tangential_restitution() const { return normal() + 5; }

 private:
  /// The mass, three moments and four components of the orientation.
  static Eigen::Index inertia_numbers(const Body& body) { return body.immovable ? 0 : 8; }
};

template <std::size_t N, class S>
[[nodiscard]] Vector3<Dual<S, N>> inputs(const Vector3<S>& numbers, std::size_t first) {
  Vector3<Dual<S, N>> result;
  for (int i = 0; i < 3; ++i) {
    result[i] = Dual<S, N>::input(numbers[i], first + static_cast<std::size_t>(i));
  }
  return result;
}

template <class S, std::size_t N>
[[nodiscard]] Vector3<S> value(const Vector3<Dual<S, N>>& numbers) {
  return {numbers[0].value, numbers[1].value, numbers[2].value};
}

template <int Count, class S, std::size_t N>
[[nodiscard]] Eigen::Matrix<S, 3, Count> derivatives(const Vector3<Dual<S, N>>& numbers, std::size_t first) {
  Eigen::Matrix<S, 3, Count> result;
  for (int i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < Count; ++j) {
      result(i, static_cast<Eigen::Index>(j)) = numbers[i].derivative[first + j];
    }
  }
  return result;
}

/// The response of one body to impulses at the contact point; zero if the body is immovable.
template <class S>
struct BodyResponse {
  // The columns are the responses to unit impulses.
  Matrix3<S> velocity = Matrix3<S>::Constant(S(0));
  Matrix3<S> angular_velocity = Matrix3<S>::Constant(S(0));
  Matrix3<S> at_point = Matrix3<S>::Constant(S(0));
  // The derivatives of the response to the impulse F, which is fixed.
  Jacobian<S> d_velocity = Jacobian<S>::Constant(S(0));
  Jacobian<S> d_angular_velocity = Jacobian<S>::Constant(S(0));
  Jacobian<S> d_at_point = Jacobian<S>::Constant(S(0));
};

template <class S>
[[nodiscard]] BodyResponse<S> response_of(const BasicBody<S>& body, const Vector3<S>& point, const Vector3<S>& impulse,
                                          const InputIndices::OfBody& index, Eigen::Index point_index) {
  BodyResponse<S> result;
  if (body.immovable) {
    return result;
  }
  const Vector3<S> arm = lever_arm<S>(body, point);
  for (int i = 0; i < 3; ++i) {
    const BodyVelocity<S> answer = response<S>(body, point, Vector3<S>::Unit(i));
    result.velocity.col(i) = answer.velocity;
    result.angular_velocity.col(i) = answer.angular_velocity;
    result.at_point.col(i) = point_velocity<S>(answer, arm);
  }
  // The inputs are the mass, three moments, four numbers of the orientation, the position, and the contact point.
  constexpr int own = 11;
  using T = Dual<S, own + 3>;
  BasicBody<T> dual;
  std::size_t next = 0;
  auto as_input = [&](const FieldPath&, const S& from, T& to) {
    to = next < own ? T::input(from, next) : T(from);
    ++next;
  };
  carom::detail::for_each_body_number("", as_input, body, dual);
  const Vector3<T> at = inputs<own + 3>(point, own);
  const BodyVelocity<T> answer = response<T>(dual, at, impulse.unaryExpr([](const S& x) { return T(x); }));
  const auto spread = [&](const Vector3<T>& from, Jacobian<S>& to) {
    to.template middleCols<own>(index.velocity() - own) = derivatives<own>(from, 0);
    to.template middleCols<3>(point_index) = derivatives<3>(from, own);
  };
  spread(answer.velocity, result.d_velocity);
  spread(answer.angular_velocity, result.d_angular_velocity);
  spread(point_velocity<T>(answer, lever_arm<T>(dual, at)), result.d_at_point);
  return result;
}

template <class S>
struct Derivatives {
  Jacobian<S> of_impulse;
  PerVector<Jacobian<S>> of_change;
};

/// The responses of both bodies to the impulse F on A and −F on B.
template <class S>
struct ImpulseDifferential {
  BodyResponse<S> a;
  BodyResponse<S> b;
  Vector3<S> impulse;
  Vector3<S> wanted;    // b, the change of relative velocity that the law requires
  Jacobian<S> left;     // dK F − db
  Eigen::Index normal;  // index of the normal among the inputs
};

/// The derivatives for a law whose impulse satisfies K F = b: dF = K⁻¹ (db − dK F).
template <class S>
[[nodiscard]] Derivatives<S> derivatives_by_matrix(const ImpulseDifferential<S>& of) {
  const DefiniteSystem<S> k(of.a.at_point + of.b.at_point);
  Jacobian<S> d_impulse;
  for (Eigen::Index j = 0; j < d_impulse.cols(); ++j) {
    d_impulse.col(j) = k.solve(-of.left.col(j));
  }
  return {d_impulse,
          {of.a.d_velocity + of.a.velocity * d_impulse, of.a.d_angular_velocity + of.a.angular_velocity * d_impulse,
           of.b.d_velocity - of.b.velocity * d_impulse, of.b.d_angular_velocity - of.b.angular_velocity * d_impulse}};
}

}  // namespace carom::oracles
