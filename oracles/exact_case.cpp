// SPDX-License-Identifier: GPL-3.0-or-later
#include <carom/oracles/exact_case.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

#include <carom/oracles/inputs.hpp>
#include <carom/oracles/laws.hpp>

namespace carom::oracles {
namespace {

Approach approach_of(const BasicCollision<Rational>& collision, const Rational& normal_velocity) {
  if (collision.a.immovable && collision.b.immovable) {
    return Approach::inert;
  }
  if (normal_velocity < 0) {
    return Approach::colliding;
  }
  return normal_velocity == 0 ? Approach::resting : Approach::separating;
}

template <int N>
void require_equal(const Sides<Rational, N>& sides, const char* equation) {
  for (int i = 0; i < N; ++i) {
    if (sides.left[i] != sides.right[i]) {
      throw std::logic_error(std::string("the truth does not satisfy ") + equation);
    }
  }
}

double as_double(double number) { return number; }
double as_double(const Rational& number) { return to_double(number); }

/// Σ_j ‖∂y/∂x_j‖ |x_j| for the components y.
template <class S, std::size_t N>
double sensitivity_of(std::initializer_list<const Dual<S, N>*> components, const std::vector<double>& magnitude) {
  double sum = 0;
  for (std::size_t j = 0; j < magnitude.size(); ++j) {
    double squared = 0;
    for (const auto* component : components) {
      const double derivative = as_double(component->derivative[j]);
      squared += derivative * derivative;
    }
    sum += std::sqrt(squared) * magnitude[j];
  }
  return sum;
}

template <class S, class Convert>
Sensitivity colliding_sensitivity(const Collision& collision, Model model, Convert&& convert) {
  const auto inputs = dual_inputs<S, collision_inputs>(collision, convert);
  const auto truth = colliding_truth(inputs.collision, model);
  Sensitivity result{};
  const auto parts = vectors(truth.outcome);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    result[k] = sensitivity_of({&(*parts[k])[0], &(*parts[k])[1], &(*parts[k])[2]}, inputs.magnitude);
  }
  return result;
}

/// An upper bound of the condition number of a symmetric positive definite matrix: its largest eigenvalue is at most the
/// trace t, the product of the other two at most (t/2)², hence κ ≤ t³ / (4 det).
double condition_bound(const Matrix3<Rational>& matrix) {
  const double trace = to_double(matrix(0, 0) + matrix(1, 1) + matrix(2, 2));
  const Rational determinant = Vector3<Rational>(matrix.col(0))
                                   .dot(Vector3<Rational>(matrix.col(1)).cross(Vector3<Rational>(matrix.col(2))));
  return trace * trace * trace / (4 * to_double(determinant));
}

}  // namespace

void certify(const BasicCollision<Rational>& collision, Model model, Approach approach,
             const Outcome<Rational>& outcome) {
  const BasicBody<Rational>& a = collision.a;
  const BasicBody<Rational>& b = collision.b;
  if (approach != Approach::colliding) {
    require_equal(untouched(a, outcome.a), "the velocities of A being untouched");
    require_equal(untouched(b, outcome.b), "the velocities of B being untouched");
    return;
  }
  if (a.immovable) {
    require_equal(untouched(a, outcome.a), "the immovable A being untouched");
  } else {
    require_equal(angular_momentum(a, collision.point, outcome.a), "the angular momentum of A");
  }
  if (b.immovable) {
    require_equal(untouched(b, outcome.b), "the immovable B being untouched");
  } else {
    require_equal(angular_momentum(b, collision.point, outcome.b), "the angular momentum of B");
  }
  if (!a.immovable && !b.immovable) {
    require_equal(linear_momentum(collision, outcome), "linear momentum");
  }
  require_equal(restitution(collision, outcome), "restitution");
  if (model == Model::frictionless) {
    require_equal(frictionless_direction(collision, outcome, !a.immovable), "the frictionless direction");
  } else {
    require_equal(reflection_plane(collision, outcome), "the reflection plane");
  }
}

ExactCase::ExactCase(const Collision& collision)
    : collision_(collision),
      exact_(lift(collision)),
      normal_velocity_(normal_velocity_before(exact_)),
      approach_(approach_of(exact_, normal_velocity_)) {}

bool ExactCase::is_grazing(double allowance) const {
  if (approach_ == Approach::inert) {
    return false;
  }
  if (!normal_velocity_sensitivity_) {
    const auto inputs = dual_inputs<double, collision_inputs>(collision_, [](double x) { return x; });
    const auto velocity = normal_velocity_before(inputs.collision);
    normal_velocity_sensitivity_ = sensitivity_of({&velocity}, inputs.magnitude);
  }
  return std::abs(to_double(normal_velocity_)) <= allowance * *normal_velocity_sensitivity_;
}

const Truth<Rational>& ExactCase::truth(Model model) const {
  const auto known = truth_.find(model);
  if (known != truth_.end()) {
    return known->second;
  }
  const Truth<Rational> truth = approach_ == Approach::colliding
                                    ? colliding_truth(exact_, model)
                                    : Truth<Rational>{{0, 0, 0}, unchanged(exact_)};
  certify(exact_, model, approach_, truth.outcome);
  return truth_.emplace(model, truth).first->second;
}

const Sensitivity& ExactCase::sensitivity(Model model, double allowance) const {
  if (approach_ != Approach::colliding && !is_grazing(allowance)) {
    if (!unchanged_sensitivity_) {
      unchanged_sensitivity_.emplace();
      const Outcome<double> outcome = unchanged(collision_);
      const auto parts = vectors(outcome);
      for (std::size_t k = 0; k < parts.size(); ++k) {
        (*unchanged_sensitivity_)[k] = parts[k]->lpNorm<1>();
      }
    }
    return *unchanged_sensitivity_;
  }
  const auto known = colliding_sensitivity_.find(model);
  if (known != colliding_sensitivity_.end()) {
    return known->second;
  }
  // Binary64 loses about κ(K) u of these sums: below 2²⁰ they keep ten digits, above they are taken in ℚ.
  constexpr double well_conditioned = 1 << 20;
  const bool in_double = model == Model::frictionless || condition_bound(collision_matrix()) < well_conditioned;
  Sensitivity result{};
  if (in_double) {
    result = colliding_sensitivity<double>(collision_, model, [](double x) { return x; });
  }
  bool usable = in_double;
  for (const double sum : result) {
    usable = usable && std::isfinite(sum);
  }
  if (!usable) {
    result = colliding_sensitivity<Rational>(collision_, model, [](double x) { return Rational(x); });
  }
  return colliding_sensitivity_.emplace(model, result).first->second;
}

const Matrix3<Rational>& ExactCase::collision_matrix() const {
  if (!collision_matrix_) {
    collision_matrix_ = response_matrix(exact_);
  }
  return *collision_matrix_;
}

double ExactCase::collision_matrix_sensitivity() const {
  if (!collision_matrix_sensitivity_) {
    const auto inputs = dual_inputs<double, collision_inputs>(collision_, [](double x) { return x; });
    const auto k = response_matrix(inputs.collision);
    collision_matrix_sensitivity_ = sensitivity_of(
        {&k(0, 0), &k(0, 1), &k(0, 2), &k(1, 0), &k(1, 1), &k(1, 2), &k(2, 0), &k(2, 1), &k(2, 2)}, inputs.magnitude);
  }
  return *collision_matrix_sensitivity_;
}

Rational ExactCase::inverse_mass() const {
  Rational sum(0);
  for (const BasicBody<Rational>* body : {&exact_.a, &exact_.b}) {
    if (!body->immovable) {
      sum += 1 / body->mass;
    }
  }
  return sum;
}

bool ExactCase::reads_impulse_off_a() const {
  return collision_.b.immovable || (!collision_.a.immovable && collision_.a.mass <= collision_.b.mass);
}

}  // namespace carom::oracles
