// SPDX-License-Identifier: BSL-1.0
#include <carom/collision/expects.hpp>
#include <carom/oracles/bounds/slopes.hpp>

namespace carom::oracles {
PerVector<double> slopes_of(const Equation& equation, const Collision& collision) {
  CAROM_EXPECTS(name_of(equation).has_value());
  return std::visit(
      [&](const auto& one) { return output_slopes<double, outcome_inputs>(one, collision, unchanged(collision)); },
      equation);
}

PerVector<double> slopes_of_change(const Matrix3<double>& matrix, bool read_off_a, const Collision& collision) {
  const Matrix3<double> identity = Matrix3<double>::Identity();
  const auto norm = [](const Matrix3<double>& m) {
    return root_of_squares(
        9, [&](std::size_t i) { return m(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)); });
  };
  // ±(I − m C) for the body whose velocity change gives F, and ±I for the other.
  const auto by_velocity = [&](const Body& body, bool gives_impulse) {
    return norm(gives_impulse ? Matrix3<double>(identity - body.mass * matrix) : identity);
  };
  // ±[r] with [r] x = r × x.
  const auto by_spin = [&](const Body& body) {
    const Vector3<double> r = lever_arm<double>(body, collision.point);
    Matrix3<double> cross;
    cross << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
    return norm(cross);
  };
  return {by_velocity(collision.a, read_off_a), by_spin(collision.a), by_velocity(collision.b, !read_off_a),
          by_spin(collision.b)};
}

}  // namespace carom::oracles
