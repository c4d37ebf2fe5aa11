// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdlib>
#include <initializer_list>
#include <string>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/contact.hpp>
#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/bounds/quantities.hpp>
#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/judge/exact_case.hpp>

#include "support/cases.hpp"

namespace carom::unit {

using oracles::Rational;
using ExactVector = Vector3<Rational>;
using ExactMatrix = Matrix3<Rational>;

using oracles::sign_of;

[[nodiscard]] inline Rational ratio(int p, int q) { return Rational(p, q); }

/// 2^exponent, by multiplication alone.
[[nodiscard]] inline Rational two_to(int exponent) {
  Rational power(1);
  Rational square = exponent < 0 ? ratio(1, 2) : Rational(2);
  for (int rest = std::abs(exponent); rest > 0; rest /= 2) {
    if (rest % 2 == 1) {
      power *= square;
    }
    square *= square;
  }
  return power;
}

template <class Derived>
[[nodiscard]] std::string to_text(const Eigen::MatrixBase<Derived>& matrix) {
  std::string text;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      text += oracles::to_text(matrix(i, j)) + ' ';
    }
  }
  return text;
}

template <class Derived, class OtherDerived>
[[nodiscard]] bool same(const Eigen::MatrixBase<Derived>& left, const Eigen::MatrixBase<OtherDerived>& right) {
  for (Eigen::Index i = 0; i < left.rows(); ++i) {
    for (Eigen::Index j = 0; j < left.cols(); ++j) {
      if (left(i, j) != right(i, j)) {
        return false;
      }
    }
  }
  return true;
}

template <class S>
[[nodiscard]] bool same(const Outcome<S>& left, const Outcome<S>& right) {
  return same(left.a.velocity, right.a.velocity) && same(left.a.angular_velocity, right.a.angular_velocity) &&
         same(left.b.velocity, right.b.velocity) && same(left.b.angular_velocity, right.b.angular_velocity);
}

[[nodiscard]] inline impulse::Contact<Rational> exact_contact(const Collision& collision) {
  return impulse::make_contact<Rational>(oracles::lift(collision));
}

/// The relative velocity V⁻ of the material points at the contact.
[[nodiscard]] inline ExactVector velocity_before(const BasicCollision<Rational>& c) {
  return oracles::relative_velocity<Rational>(c, unchanged(c));
}

[[nodiscard]] inline Rational exact_eighths(properties::Stream& stream, int most) {
  return ratio(stream.integer(-most, most), 8);
}

[[nodiscard]] inline ExactVector exact_eighths3(properties::Stream& stream, int most) {
  ExactVector result;
  for (int i = 0; i < 3; ++i) {
    result[i] = exact_eighths(stream, most);
  }
  return result;
}

using EnclosedDual = oracles::Dual<oracles::Enclosure, oracles::collision_inputs>;

[[nodiscard]] inline oracles::DualInputs<oracles::Enclosure, oracles::collision_inputs> enclosed_inputs(
    const Collision& collision) {
  return oracles::dual_inputs<oracles::Enclosure, oracles::collision_inputs>(
      collision, [](double x) { return oracles::Enclosure(x); });
}

/// A bound of Σ_q ‖∂y/∂q‖ ‖q‖ for a vector y with these components: an upper one by Enclosure::magnitude_above, or a
/// lower one by Enclosure::magnitude_below.
[[nodiscard]] inline double sensitivity_by(double (oracles::Enclosure::*bound)() const,
                                           std::initializer_list<const EnclosedDual*> components,
                                           const std::vector<oracles::Quantity>& quantities) {
  return oracles::sum_over_quantities(quantities, components.size(), [&](std::size_t i, std::size_t j) {
    return (components.begin()[i]->derivative[j].*bound)();
  });
}

}  // namespace carom::unit
