// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include <carom/oracles/bounds/certain_sign.hpp>
#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/bounds/stage.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/norm_at_most.hpp>

namespace carom::oracles {
namespace {

/// Twice the kinetic energy of the movable bodies: Σ (m v² + Σ_i I_i w_i²), with w_i the components of w along the body
/// axes.
template <class T>
T twice_energy(const BasicCollision<T>& collision, const Outcome<T>& change) {
  T sum(0);
  const auto add = [&](const BasicBody<T>& body, const BodyVelocity<T>& of_body) {
    if (!body.immovable) {
      const Vector3<T> w = turned<T>(conjugate(body.orientation), of_body.angular_velocity);
      sum += body.mass * of_body.velocity.dot(of_body.velocity) + body.principal_inertia.dot(w.cwiseProduct(w));
    }
  };
  add(collision.a, change.a);
  add(collision.b, change.b);
  return sum;
}

template <class T>
Outcome<T> minus(const Outcome<T>& x, const Outcome<T>& y) {
  return {{x.a.velocity - y.a.velocity, x.a.angular_velocity - y.a.angular_velocity},
          {x.b.velocity - y.b.velocity, x.b.angular_velocity - y.b.angular_velocity}};
}

template <class T>
inline constexpr bool is_exact = std::is_same_v<T, Rational> || std::is_same_v<T, Radical>;

template <class T>
BasicCollision<T> collision_in(const ExactCase& exact_case) {
  return map_numbers<T>(exact_case.collision(), [](double number) { return T(number); });
}
template <class T>
Outcome<T> outcome_in(const LiftedOutcome& outcome) {
  return map_outcome<T>(outcome.exact(), [](const Rational& x) { return T(x); });
}

/// Whether ‖ŷ − y‖ ≤ bound ‖y − y⁻‖ in the kinetic-energy norm (accuracy.hpp). No value if T does not decide it.
template <class T>
std::optional<bool> relative_error_at_most(double bound, const BasicCollision<T>& collision, const Truth<T>& truth,
                                           const Outcome<T>& outcome) {
  const T energy_of_error = twice_energy(collision, minus(outcome, truth.outcome));
  const T change = twice_energy(collision, minus(truth.outcome, unchanged(collision)));
  const std::optional<int> sign = certain_sign(T(T(bound) * T(bound) * change - energy_of_error));
  return sign ? std::optional<bool>(*sign >= 0) : std::nullopt;
}

/// The error of each vector of an outcome, and the part of the accuracy that needs no sensitivity.
template <class T>
struct ErrorVectors {
  PerVector<Components<T>> of_vector;
  Accuracy accuracy;
};

/// The length of a change of velocities in the kinetic-energy norm (accuracy.hpp), rounded.
double energy_norm(const Collision& collision, const Outcome<double>& change) {
  return std::sqrt(twice_energy(collision, change));
}

/// The length of the change by an outcome.
template <class T>
double size_of_change(const ExactCase& exact_case, const BasicCollision<T>& collision, const Outcome<T>& outcome) {
  return energy_norm(exact_case.collision(),
                     map_outcome<double>(minus(outcome, unchanged(collision)), [](const T& x) { return rounded(x); }));
}

/// `size_of_truth()` is the `size_of_change` of the truth.
template <class T, class SizeOfTruth>
ErrorVectors<T> errors_of(const ExactCase& exact_case, const Truth<T>& truth, const Outcome<T>& outcome,
                          const SizeOfTruth& size_of_truth) {
  ErrorVectors<T> result;
  Accuracy& accuracy = result.accuracy;
  const auto computed = vectors(outcome);
  const auto exact = vectors(truth.outcome);
  Outcome<double> errors;
  const auto of_errors = vectors(errors);
  for (const OutcomeVector k : all_outcome_vectors) {
    const Components<T>& error = result.of_vector[k] = difference(*computed[k], *exact[k]);
    for (int i = 0; i < 3; ++i) {
      (*of_errors[k])[i] = rounded(error[static_cast<std::size_t>(i)]);
    }
    accuracy.error[k] = norm_of(*of_errors[k]);
  }
  if (std::any_of(accuracy.error.begin(), accuracy.error.end(), [](double error) { return error != 0; })) {
    const double norm_of_error = energy_norm(exact_case.collision(), errors);
    const double norm_of_change = size_of_truth();
    const double ratio = norm_of_error / norm_of_change;
    // If the change is zero, or squares leave the range of binary64, the error counts as infinite.
    const bool is_known = norm_of_error > 0 && norm_of_change > 0 && std::isfinite(ratio);
    accuracy.relative_error = is_known ? ratio : std::numeric_limits<double>::infinity();
  }
  return result;
}

/// The accuracy with this sensitivity. No value if T does not decide it, or if a radius is too large for print.
template <class T>
std::optional<Accuracy> accuracy_by(const ErrorVectors<T>& errors, const Sensitivity& sensitivity,
                                    const Yardstick& yardstick, const PerVector<double>& noise) {
  Accuracy result = errors.accuracy;
  result.sensitivity = sensitivity;
  for (const OutcomeVector k : all_outcome_vectors) {
    const double allowance = yardstick.allowance() * sensitivity[k] + noise[k];
    const std::optional<bool> allowed = norm_at_most(errors.of_vector[k], allowance);
    if (!allowed) {
      return std::nullopt;
    }
    result.allowed[k] = *allowed;
    if constexpr (!is_exact<T>) {
      // A component is precise enough for print if its radius is at most a thousandth of the component or of the
      // permitted error.
      constexpr double thousandth = 0x1p-10;
      for (const T& component : errors.of_vector[k]) {
        if (component.radius() > thousandth * std::max(component.magnitude_below(), allowance)) {
          return std::nullopt;
        }
      }
    }
  }
  return result;
}

double digits_by(double relative_error) {
  constexpr double exact = 40;
  return relative_error > 0 ? std::min(exact, -std::log10(relative_error)) : exact;
}

}  // namespace

double Accuracy::backward_error(double unit_roundoff) const {
  double worst = 0;
  for (const OutcomeVector k : all_outcome_vectors) {
    if (error[k] > 0) {
      worst = std::max(worst, error[k] / (unit_roundoff * sensitivity[k]));
    }
  }
  return worst;
}

double Accuracy::digits() const { return digits_by(relative_error); }

double digits_of(const BasicCollision<Rational>& collision, const Outcome<Rational>& exact,
                 const Outcome<Rational>& computed) {
  const Rational energy_of_error = twice_energy(collision, minus(computed, exact));
  const Rational change = twice_energy(collision, minus(exact, unchanged(collision)));
  if (change == 0) {
    return digits_by(energy_of_error == 0 ? 0 : HUGE_VAL);
  }
  return digits_by(std::sqrt(nearest_double(Rational(energy_of_error / change))));
}

namespace {

/// The accuracy of an outcome by the law's answer to a contact of approach `as`.
Accuracy accuracy_as(const ExactCase& exact_case, Law law, ContactState as, const LiftedOutcome& outcome,
                     const Yardstick& yardstick, double known) {
  const bool may_use_bounds = yardstick.filtered() && yardstick.allowance() > 0;
  const auto with_digits = [&](Accuracy accuracy) {
    if (yardstick.digits()) {
      const double bound = yardstick.allowance();
      const std::optional<bool> decided =
          may_use_bounds ? relative_error_at_most(bound, exact_case.enclosed(), exact_case.enclosed_truth(law, as),
                                                  outcome.enclosed())
                         : std::nullopt;
      accuracy.has_digits = decided ? *decided : exact_case.with_truth(law, as, [&]<class T>(const Truth<T>& truth) {
        return *relative_error_at_most(bound, collision_in<T>(exact_case), truth, outcome_in<T>(outcome));
      });
    }
    return accuracy;
  };
  const PerVector<double> noise = permitted_noise(exact_case.collision(), yardstick);
  std::optional<ErrorVectors<Enclosure>> enclosed;
  const auto by_enclosures = [&](const Sensitivity& sensitivity) {
    if (!enclosed) {
      const Truth<Enclosure>& truth = exact_case.enclosed_truth(law, as);
      enclosed = errors_of(exact_case, truth, outcome.enclosed(), [&] {
        return exact_case.size_of_change(
            law, as, [&] { return size_of_change(exact_case, exact_case.enclosed(), truth.outcome); });
      });
    }
    return accuracy_by(*enclosed, sensitivity, yardstick, noise);
  };
  // If a lower bound of the sensitivity permits an error, the sensitivity permits it, too. The sensitivity of moderate
  // numbers is finite. The reported errors depend neither on the sensitivity nor on `known`.
  if (yardstick.uses_bounds() && as == exact_case.state() && exact_case.is_moderate(law) && outcome.is_moderate()) {
    const Sensitivity& below = exact_case.sensitivity_below(law);
    const auto bounded = by_enclosures(below);
    if (bounded && bounded->is_allowed() && bounded->backward_error(yardstick.unit_roundoff()) <= known) {
      count(Stage::enclosure);
      return with_digits(*bounded);
    }
  }
  const Sensitivity sensitivity = as == exact_case.state() ? exact_case.sensitivity(law, yardstick.allowance())
                                                           : exact_case.sensitivity_as(law, as, yardstick.allowance());
  for (const double sum : sensitivity) {
    if (!yardstick.allowed(sum)) {
      return {.is_decided = false};
    }
  }
  if (may_use_bounds) {
    if (const auto decided = by_enclosures(sensitivity)) {
      if (!decided->is_allowed()) {
        exact_case.check_enclosed_truth(law, as);  // before a subject is blamed
      }
      count(Stage::enclosure);
      return with_digits(*decided);
    }
  }
  count(Stage::rational);
  return exact_case.with_truth(law, as, [&]<class T>(const Truth<T>& truth) {
    const auto exactly = errors_of(exact_case, truth, outcome_in<T>(outcome), [&] {
      return size_of_change(exact_case, collision_in<T>(exact_case), truth.outcome);
    });
    return with_digits(*accuracy_by(exactly, sensitivity, yardstick, noise));
  });
}

bool passes(const Accuracy& accuracy) {
  return accuracy.is_decided && (accuracy.is_allowed() || accuracy.has_digits.value_or(false));
}

}  // namespace

Accuracy accuracy(const ExactCase& exact_case, Law law, const LiftedOutcome& outcome, const Yardstick& yardstick,
                  double known) {
  const ContactState approach = exact_case.state();
  if (exact_case.is_open(law, yardstick.allowance())) {
    return {.is_decided = false};
  }
  if (!exact_case.has_two_answers(law, yardstick.allowance())) {
    return accuracy_as(exact_case, law, approach, outcome, yardstick, known);
  }
  // The nearer answer is found by backward errors, so these must not depend on `known`.
  const Accuracy own = accuracy_as(exact_case, law, approach, outcome, yardstick, 0);
  const ContactState other = approach == ContactState::colliding ? ContactState::separating : ContactState::colliding;
  Accuracy result = accuracy_as(exact_case, law, other, outcome, yardstick, 0);
  if (!passes(result)) {
    return own;
  }
  const bool is_nearer =
      result.backward_error(yardstick.unit_roundoff()) < own.backward_error(yardstick.unit_roundoff());
  if (passes(own) && !is_nearer) {
    return own;
  }
  result.is_of_truth = false;
  return result;
}

}  // namespace carom::oracles
