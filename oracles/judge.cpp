// SPDX-License-Identifier: GPL-3.0-or-later
#include <carom/oracles/judge.hpp>

#include <algorithm>
#include <limits>

namespace carom::oracles {
namespace {

/// m v² + wᵀ J w of a movable body, twice the kinetic energy; only compared as a ratio.
double energy_norm_squared(const BasicBody<double>& body, const BodyVelocity<double>& change) {
  if (body.immovable) {
    return 0;
  }
  return body.mass * change.velocity.squaredNorm() +
         change.angular_velocity.dot(apply_inertia<double>(body, change.angular_velocity));
}

double energy_norm(const Collision& collision, const Outcome<double>& change) {
  return std::sqrt(energy_norm_squared(collision.a, change.a) + energy_norm_squared(collision.b, change.b));
}

Outcome<double> difference(const Outcome<Rational>& left, const Outcome<Rational>& right) {
  Outcome<double> result;
  const auto from = vectors(left);
  const auto minus = vectors(right);
  const auto to = vectors(result);
  for (std::size_t k = 0; k < to.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      (*to[k])[i] = to_double((*from[k])[i] - (*minus[k])[i]);
    }
  }
  return result;
}

}  // namespace

double Accuracy::backward_error(double unit_roundoff) const {
  double worst = 0;
  for (std::size_t k = 0; k < error.size(); ++k) {
    if (error[k] > 0) {
      worst = std::max(worst, error[k] / (unit_roundoff * sensitivity[k]));
    }
  }
  return worst;
}

double Accuracy::digits() const {
  constexpr double exact = 40;
  return relative_error > 0 ? std::min(exact, -std::log10(relative_error)) : exact;
}

Accuracy accuracy(const ExactCase& exact_case, Model model, const Outcome<Rational>& outcome, double allowance) {
  const Truth<Rational>& truth = exact_case.truth(model);
  const Outcome<double> deviation = difference(outcome, truth.outcome);
  const Outcome<double> change = difference(truth.outcome, unchanged(exact_case.exact()));
  Accuracy result;
  result.sensitivity = exact_case.sensitivity(model, allowance);
  const auto parts = vectors(deviation);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    result.error[k] = parts[k]->stableNorm();
  }
  const double norm_of_deviation = energy_norm(exact_case.collision(), deviation);
  if (norm_of_deviation > 0) {
    const double norm_of_change = energy_norm(exact_case.collision(), change);
    result.relative_error =
        norm_of_change > 0 ? norm_of_deviation / norm_of_change : std::numeric_limits<double>::infinity();
  }
  return result;
}

}  // namespace carom::oracles
