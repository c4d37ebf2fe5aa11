// SPDX-License-Identifier: BSL-1.0
#include <carom/collision/expects.hpp>
#include <carom/oracles/filters/slopes.hpp>

namespace carom::oracles {
namespace {

/// A collision with two movable bodies, in which no number is zero or occurs twice, so that no derivative vanishes by
/// chance.
Collision general_collision() {
  Collision c;
  double last = 1;
  for_each_number([&](const FieldPath&, double& number) { number = last += 1 / last; }, c);
  return c;
}

}  // namespace

PerVector<double> slopes_of(const Equation& equation, const Collision& collision) {
  CAROM_EXPECTS(name_of(equation).has_value());
  return std::visit(
      [&](const auto& one) { return output_slopes<double, outcome_inputs>(one, collision, unchanged(collision)); },
      equation);
}

const PerVector<bool>& vectors_in(AffineEquation equation) {
  static const PerAffineEquation<PerVector<bool>> known = [] {
    PerAffineEquation<PerVector<bool>> result{};
    for (const Equation& one : affine_equations) {
      const PerVector<double> slopes = slopes_of(one, general_collision());
      for (const OutcomeVector k : all_outcome_vectors) {
        result[*name_of(one)][k] = slopes[k] != 0;
      }
    }
    return result;
  }();
  return known[equation];
}

}  // namespace carom::oracles
