// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <carom/oracles/definiteness.hpp>
#include <carom/oracles/exact_case.hpp>
#include <carom/oracles/inputs.hpp>
#include <carom/oracles/laws.hpp>
#include <carom/oracles/moderate.hpp>
#include <carom/oracles/refined_truth.hpp>

namespace carom::oracles {
namespace {

Approach approach_of_sign(int sign) {
  if (sign < 0) {
    return Approach::colliding;
  }
  return sign == 0 ? Approach::resting : Approach::separating;
}

int sign_of(const Rational& number) { return number < 0 ? -1 : (number > 0 ? 1 : 0); }

template <class T>
Truth<T> truth_of(const BasicCollision<T>& collision, Model model, Approach approach) {
  return approach == Approach::colliding ? colliding_truth(collision, model)
                                         : Truth<T>{{T(0), T(0), T(0)}, unchanged(collision)};
}

template <int N>
void require_equal(const Sides<Rational, N>& sides, const char* equation) {
  for (int i = 0; i < N; ++i) {
    if (sides.left[i] != sides.right[i]) {
      throw std::logic_error(std::string("the truth does not satisfy ") + equation);
    }
  }
}

/// Whether a vector is zero: not where an approximation excludes it, else exactly.
template <class Exactly>
bool is_zero(const Vector3<Approximation>& approximate, const Exactly& exactly) {
  for (int i = 0; i < 3; ++i) {
    if (approximate[i].sign().value_or(0) != 0) {
      return false;
    }
  }
  const Vector3<Rational> exact = exactly();
  return exact[0] == 0 && exact[1] == 0 && exact[2] == 0;
}

double as_double(double number) { return number; }
double as_double(const Rational& number) { return to_double(number); }
double as_double(const Enclosure& number) { return number.magnitude_above(); }

/// Σ_j ‖∂y/∂x_j‖ |x_j| for the components y.
template <class S, std::size_t N>
double sensitivity_of(std::initializer_list<const Dual<S, N>*> components, const std::vector<double>& magnitude) {
  double sum = 0;
  for (std::size_t j = 0; j < magnitude.size(); ++j) {
    double norm = 0;
    for (const auto* component : components) {
      norm = std::hypot(norm, as_double(component->derivative[j]));
    }
    // A number that is zero cannot be perturbed relatively, however steep the law is there.
    sum += magnitude[j] == 0 ? 0 : norm * magnitude[j];
  }
  return sum;
}

/// ‖y_k⁻‖.
Sensitivity norms_before(const Collision& collision) {
  const Outcome<double> before = unchanged(collision);
  const auto parts = vectors(before);
  return {parts[0]->stableNorm(), parts[1]->stableNorm(), parts[2]->stableNorm(), parts[3]->stableNorm()};
}

template <class S, class Convert>
Sensitivity colliding_sensitivity(const Collision& collision, Model model, Convert&& convert) {
  const auto inputs = dual_inputs<S, collision_inputs>(collision, convert);
  const auto truth = colliding_truth(inputs.collision, model);
  Sensitivity result = norms_before(collision);
  const auto parts = vectors(truth.outcome);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    result[k] += sensitivity_of({&(*parts[k])[0], &(*parts[k])[1], &(*parts[k])[2]}, inputs.magnitude);
  }
  return result;
}

/// The same in enclosures, from above; none where it is not known to ten digits.
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
    if (!(unknown <= 0x1p-34 * result[k]) || !std::isfinite(result[k])) {
      return std::nullopt;
    }
  }
  return result;
}

/// An upper bound of the condition number of a symmetric positive definite matrix: its largest eigenvalue is at most
/// the trace t, the product of the other two at most (t/2)², hence κ ≤ t³ / (4 det).
double condition_bound(const Matrix3<Approximation>& matrix) {
  const double trace = (matrix(0, 0) + matrix(1, 1) + matrix(2, 2)).magnitude_above();
  const Vector3<Approximation> c0 = matrix.col(0);
  const Vector3<Approximation> c1 = matrix.col(1);
  const Vector3<Approximation> c2 = matrix.col(2);
  return trace * trace * trace / (4 * c0.dot(c1.cross(c2)).magnitude_below());
}

/// λ = 1/m_A + 1/m_B.
template <class T>
T inverse_mass_of(const BasicCollision<T>& collision) {
  T sum(0);
  for (const BasicBody<T>* body : {&collision.a, &collision.b}) {
    if (!body->immovable) {
      sum += T(1) / body->mass;
    }
  }
  return sum;
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

ExactCase::ExactCase(const Collision& collision) : collision_(collision) {}

const BasicCollision<Enclosure>& ExactCase::enclosed() const {
  if (!enclosed_) {
    enclosed_ = map_numbers<Enclosure>(collision_, [](double number) { return Enclosure(number); });
  }
  return *enclosed_;
}

const BasicCollision<Approximation>& ExactCase::approximate() const {
  if (!approximate_) {
    approximate_ = map_numbers<Approximation>(collision_, [](double number) { return Approximation(number); });
  }
  return *approximate_;
}

bool ExactCase::is_moderate() const {
  if (!is_moderate_) {
    is_moderate_ = oracles::is_moderate(collision_);
  }
  return *is_moderate_;
}

const std::array<double, 4>& ExactCase::norms_before() const {
  if (!norms_before_) {
    norms_before_ = oracles::norms_before(collision_);
  }
  return *norms_before_;
}

const ExactCase::NormalVelocity& ExactCase::normal_velocity() const {
  if (!normal_velocity_) {
    const Approximation approximately = normal_velocity_before(approximate());
    if (const std::optional<int> sign = approximately.sign()) {
      normal_velocity_ = {approximately.middle(), *sign};
    } else {
      const Rational exactly = normal_velocity_before(exact());
      normal_velocity_ = {to_double(exactly), sign_of(exactly)};
    }
  }
  return *normal_velocity_;
}

Approach ExactCase::approach() const {
  return collision_.a.immovable && collision_.b.immovable ? Approach::inert : approach_of_sign(normal_velocity().sign);
}

const BasicCollision<Rational>& ExactCase::exact() const {
  if (!exact_) {
    exact_ = lift(collision_);
  }
  return *exact_;
}

bool ExactCase::is_grazing(double allowance) const {
  if (approach() == Approach::inert) {
    return false;
  }
  if (!normal_velocity_sensitivity_) {
    const auto inputs = dual_inputs<double, collision_inputs>(collision_, [](double x) { return x; });
    const auto velocity = normal_velocity_before(inputs.collision);
    normal_velocity_sensitivity_ = sensitivity_of({&velocity}, inputs.magnitude);
  }
  return std::abs(normal_velocity().value) <= allowance * *normal_velocity_sensitivity_;
}

const Truth<Rational>& ExactCase::truth(Model model) const {
  std::optional<Truth<Rational>>& known = of(model).truth;
  if (!known) {
    Truth<Rational> truth = truth_of(exact(), model, approach());
    certify(exact(), model, approach(), truth.outcome);
    known = std::move(truth);
  }
  return *known;
}

const Truth<Enclosure>& ExactCase::enclosed_truth(Model model) const {
  std::optional<Truth<Enclosure>>& known = of(model).enclosed_truth;
  if (!known) {
    if (is_moderate() && approach() == Approach::colliding) {
      known = refined_truth(enclosed(), approximate(), model, approximate_truth(model), approximate_collision_matrix());
    }
    if (!known || !is_bounded(*known)) {
      known = truth_of(enclosed(), model, approach());
    }
  }
  return *known;
}

const Truth<Approximation>& ExactCase::approximate_truth(Model model) const {
  std::optional<Truth<Approximation>>& known = of(model).approximate_truth;
  if (!known) {
    known = truth_of(approximate(), model, approach());
  }
  return *known;
}

const Sensitivity& ExactCase::unchanged_sensitivity() const {
  if (!unchanged_sensitivity_) {
    unchanged_sensitivity_ = norms_before();
    const Outcome<double> outcome = unchanged(collision_);
    const auto parts = vectors(outcome);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      (*unchanged_sensitivity_)[k] += parts[k]->lpNorm<1>();
    }
  }
  return *unchanged_sensitivity_;
}

const Sensitivity& ExactCase::sensitivity(Model model, double allowance) const {
  if (approach() != Approach::colliding && !is_grazing(allowance)) {
    return unchanged_sensitivity();
  }
  std::optional<Sensitivity>& known = of(model).colliding_sensitivity;
  if (known) {
    return *known;
  }
  // Binary64 loses about κ(K) u of these sums: below 2²⁰ they keep ten digits, above they are taken in enclosures,
  // and where these do not keep them either, in ℚ.
  constexpr double well_conditioned = 1 << 20;
  const bool in_double =
      model == Model::frictionless || condition_bound(approximate_collision_matrix()) < well_conditioned;
  Sensitivity result{};
  if (in_double) {
    result = colliding_sensitivity<double>(collision_, model, [](double x) { return x; });
  }
  bool usable = in_double;
  for (const double sum : result) {
    usable = usable && std::isfinite(sum);
  }
  if (!usable) {
    if (const auto enclosed = enclosed_sensitivity(collision_, model)) {
      known = enclosed;
      return *known;
    }
    result = colliding_sensitivity<Rational>(collision_, model, [](double x) { return Rational(x); });
  }
  known = result;
  return *known;
}

const Sensitivity& ExactCase::sensitivity_below(Model model) const {
  std::optional<Sensitivity>& known = of(model).sensitivity_below;
  if (known) {
    return *known;
  }
  known = norms_before();
  if (approach() == Approach::colliding) {
    const Outcome<Approximation>& outcome = approximate_truth(model).outcome;
    const auto parts = vectors(outcome);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Vector3<Approximation>& y = *parts[k];
      const double half =
          std::sqrt(y[0].magnitude_below() * y[0].magnitude_below() + y[1].magnitude_below() * y[1].magnitude_below() +
                    y[2].magnitude_below() * y[2].magnitude_below()) /
          2;
      (*known)[k] += std::isfinite(half) ? half * (1 - 0x1p-40) : 0;  // three squares, two sums and a root
    }
  }
  return *known;
}

const Matrix3<Rational>& ExactCase::collision_matrix() const {
  if (!collision_matrix_) {
    collision_matrix_ = response_matrix(exact());
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

const Matrix3<Approximation>& ExactCase::approximate_collision_matrix() const {
  if (!approximate_collision_matrix_) {
    approximate_collision_matrix_ = response_matrix(approximate());
  }
  return *approximate_collision_matrix_;
}

Approximation ExactCase::approximate_inverse_mass() const { return inverse_mass_of(approximate()); }

Enclosure ExactCase::enclosed_inverse_mass() const { return inverse_mass_of(enclosed()); }

double ExactCase::collision_matrix_sensitivity_below() const {
  if (!collision_matrix_sensitivity_below_) {
    const Matrix3<Approximation>& matrix = approximate_collision_matrix();
    double squares = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        squares += matrix(i, j).magnitude_below() * matrix(i, j).magnitude_below();
      }
    }
    double largest_terms = 0;
    for (const Body* body : {&collision_.a, &collision_.b}) {
      if (!body->immovable) {
        largest_terms += lever_arm(*body, collision_.point).squaredNorm() / body->principal_inertia.minCoeff();
      }
    }
    const double norm = std::sqrt(squares);
    const double lambda = approximate_inverse_mass().magnitude_below();
    collision_matrix_sensitivity_below_ = norm >= 0x1p-20 * largest_terms ? std::max(norm, lambda) / 2 : lambda / 2;
  }
  return *collision_matrix_sensitivity_below_;
}

bool ExactCase::is_definite() const {
  if (!is_definite_) {
    is_definite_ = is_at_least(collision_matrix(), inverse_mass());
  }
  return *is_definite_;
}

bool ExactCase::is_bounded_by(const Rational& bound) const {
  const Matrix3<Enclosure> matrix = response_matrix(enclosed());
  const std::optional<bool> decided =
      is_positive_semidefinite(less_multiple_of_identity<Enclosure>(-matrix, Enclosure(Rational(-bound))));
  return decided ? *decided : is_at_most(collision_matrix(), bound);
}

bool ExactCase::is_collinear() const {
  const BasicCollision<Approximation>& near = approximate();
  const auto is_along_normal = [&](const BasicBody<Approximation>& body, const auto& exact_body) {
    return body.immovable || is_zero(lever_arm(body, near.point).cross(near.normal),
                                     [&] { return lever_arm(exact_body(), exact().point).cross(exact().normal); });
  };
  return is_along_normal(
             near.a, [&]() -> const auto& { return exact().a; }) &&
         is_along_normal(
             near.b, [&]() -> const auto& { return exact().b; });
}

bool ExactCase::is_head_on() const {
  const BasicCollision<Approximation>& near = approximate();
  return is_zero(near.normal.cross(relative_velocity<Approximation>(near, unchanged(near))),
                 [&] { return exact().normal.cross(relative_velocity<Rational>(exact(), unchanged(exact()))); });
}

Rational ExactCase::inverse_mass() const { return inverse_mass_of(exact()); }

bool ExactCase::reads_impulse_off_a() const {
  return collision_.b.immovable || (!collision_.a.immovable && collision_.a.mass <= collision_.b.mass);
}

}  // namespace carom::oracles
