// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <stdexcept>

#include <CGAL/Linear_algebraCd.h>
#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/oracles/exact/elimination.hpp>
#include <carom/oracles/exact/gmpq.hpp>

namespace carom::oracles {
namespace {

constexpr int unknowns = 15;
constexpr int first_of_f = 12;  // columns 0-2 v_A, 3-5 w_A, 6-8 v_B, 9-11 w_B, 12-14 F

using System = std::array<std::array<Rational, unknowns + 1>, unknowns>;  // the last column is the right-hand side
using Rows3 = std::array<std::array<Rational, 3>, 3>;

/// The matrix [x] with [x] y = x × y.
Rows3 cross_product(const Vector3<Rational>& x) {
  const Rational zero(0);
  return {{{zero, -x[2], x[1]}, {x[2], zero, -x[0]}, {-x[1], x[0], zero}}};
}

Rows3 inertia_tensor(const BasicBody<Rational>& body) {
  const Rational w = body.orientation[0];
  const std::array<Rational, 3> q{body.orientation[1], body.orientation[2], body.orientation[3]};
  const Rational imaginary = q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
  const Rational squared_length = w * w + imaginary;
  const Rows3 skew = cross_product({q[0], q[1], q[2]});
  Rows3 rotation;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      Rational entry = 2 * q[i] * q[j] + 2 * w * skew[i][j];
      if (i == j) {
        entry += w * w - imaginary;
      }
      rotation[i][j] = entry / squared_length;
    }
  }
  Rows3 tensor;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      tensor[i][j] = Rational(0);
      for (std::size_t k = 0; k < 3; ++k) {
        tensor[i][j] += rotation[i][k] * body.principal_inertia[static_cast<int>(k)] * rotation[j][k];
      }
    }
  }
  return tensor;
}

/// Newton's and Euler's laws for one body in six rows: m v⁺ − s F = m v⁻ and J w⁺ − s r × F = J w⁻. s is `sign`, 1 for
/// A and −1 for B.
void write_body(System& system, std::size_t first, const BasicBody<Rational>& body, const Vector3<Rational>& point,
                int sign) {
  const Rows3 tensor = body.immovable ? Rows3{} : inertia_tensor(body);
  const Rows3 arm = cross_product(point - body.position);
  for (std::size_t i = 0; i < 3; ++i) {
    auto& linear = system[first + i];
    auto& angular = system[first + 3 + i];
    const int axis = static_cast<int>(i);
    if (body.immovable) {
      linear[first + i] = 1;
      linear[unknowns] = body.velocity[axis];
      angular[first + 3 + i] = 1;
      angular[unknowns] = body.angular_velocity[axis];
      continue;
    }
    linear[first + i] = body.mass;
    linear[first_of_f + i] = -sign;
    linear[unknowns] = body.mass * body.velocity[axis];
    for (std::size_t j = 0; j < 3; ++j) {
      angular[first + 3 + j] = tensor[i][j];
      angular[first_of_f + j] = -sign * arm[i][j];
      angular[unknowns] += tensor[i][j] * body.angular_velocity[static_cast<int>(j)];
    }
  }
}

/// The row x·V⁺ = right. V⁺ is v_A + w_A × r_A − v_B − w_B × r_B, and x·(w × r) = w·(r × x).
void write_relative_velocity(System& system, std::size_t row, const BasicCollision<Rational>& c,
                             const Vector3<Rational>& x, const Rational& right) {
  const Vector3<Rational> moment_a = (c.point - c.a.position).cross(x);
  const Vector3<Rational> moment_b = (c.point - c.b.position).cross(x);
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    system[row][i] = x[axis];
    system[row][3 + i] = moment_a[axis];
    system[row][6 + i] = -x[axis];
    system[row][9 + i] = -moment_b[axis];
  }
  system[row][unknowns] = right;
}

Rational velocity_before_along(const BasicCollision<Rational>& c, const Vector3<Rational>& x) {
  return x.dot(c.a.velocity - c.b.velocity) + c.a.angular_velocity.dot((c.point - c.a.position).cross(x)) -
         c.b.angular_velocity.dot((c.point - c.b.position).cross(x));
}

/// Two vectors that span the plane normal to N.
std::array<Vector3<Rational>, 2> tangents(const Vector3<Rational>& n) {
  Eigen::Index largest{};
  n.cwiseAbs().maxCoeff(&largest);
  std::array<Vector3<Rational>, 2> result;
  for (int k = 0; k < 2; ++k) {
    const Eigen::Index other = (largest + 1 + k) % 3;
    Vector3<Rational> tangent{0, 0, 0};
    tangent[other] = n[largest];
    tangent[largest] = -n[other];
    result[static_cast<std::size_t>(k)] = tangent;
  }
  return result;
}

void write_tangential_law(System& system, std::size_t row, const BasicCollision<Rational>& c,
                          const Vector3<Rational>& t, Law law) {
  switch (law) {
    case Law::frictionless:  // t·F = 0
      for (std::size_t i = 0; i < 3; ++i) {
        system[row][first_of_f + i] = t[static_cast<int>(i)];
      }
      return;
    case Law::reflection:  // t·V⁺ = t·V⁻
      write_relative_velocity(system, row, c, t, velocity_before_along(c, t));
      return;
    case Law::sticking:  // t·V⁺ = 0
      write_relative_velocity(system, row, c, t, Rational(0));
      return;
    case Law::rough:
      throw std::invalid_argument("the law `rough` is not a linear system");
    case Law::coulomb:
    case Law::any:
      break;
  }
  determines_no_outcome(law);
}

std::array<Rational, unknowns> solved(const System& system) {
  using Algebra = CGAL::Linear_algebraCd<CGAL::Gmpq>;
  Algebra::Matrix left(unknowns, unknowns);
  Algebra::Vector right(unknowns);
  for (int row = 0; row < unknowns; ++row) {
    const auto& equation = system[static_cast<std::size_t>(row)];
    for (int column = 0; column < unknowns; ++column) {
      left[row][column] = Rational::Number::of(equation[static_cast<std::size_t>(column)]);
    }
    right[row] = Rational::Number::of(equation[unknowns]);
  }
  Algebra::Vector numerators;
  CGAL::Gmpq denominator;
  Algebra::Matrix kernel;
  Algebra::Vector certificate;
  if (!Algebra::linear_solver(left, right, numerators, denominator, kernel, certificate) ||
      kernel.column_dimension() != 0) {
    throw std::logic_error("the defining equations are singular");
  }
  std::array<Rational, unknowns> solution;
  for (int i = 0; i < unknowns; ++i) {
    solution[static_cast<std::size_t>(i)] = Rational::Number::made([&] { return numerators[i] / denominator; });
  }
  return solution;
}

}  // namespace

Truth<Rational> truth_by_elimination(const BasicCollision<Rational>& collision, Law law) {
  CAROM_EXPECTS(has_movable_body(collision));
  System system{};
  write_body(system, 0, collision.a, collision.point, 1);
  write_body(system, 6, collision.b, collision.point, -1);
  const Vector3<Rational>& n = collision.normal;
  write_relative_velocity(system, 12, collision, n, -collision.restitution * velocity_before_along(collision, n));
  const auto tangent = tangents(n);
  for (std::size_t k = 0; k < tangent.size(); ++k) {
    write_tangential_law(system, 13 + k, collision, tangent[k], law);
  }
  const auto x = solved(system);
  const auto part = [&](std::size_t first) { return Vector3<Rational>{x[first], x[first + 1], x[first + 2]}; };
  return {part(first_of_f), {{part(0), part(3)}, {part(6), part(9)}}};
}

}  // namespace carom::oracles
