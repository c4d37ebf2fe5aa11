// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <carom/oracles/exact/definiteness.hpp>
#include <carom/oracles/filters/case_bounds.hpp>
#include <carom/oracles/filters/moderate.hpp>
#include <carom/oracles/filters/refined_truth.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/models/sensitivity.hpp>

namespace carom::oracles {
namespace {

Approach approach_of_sign(int sign) {
  if (sign < 0) {
    return Approach::colliding;
  }
  return sign == 0 ? Approach::resting : Approach::separating;
}

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

/// An upper bound of the condition number of a symmetric positive definite matrix: its largest eigenvalue is at most
/// the trace t, the product of the other two at most (t/2)², hence κ ≤ t³ / (4 det).
double condition_bound(const Matrix3<Approximation>& matrix) {
  const double trace = (matrix(0, 0) + matrix(1, 1) + matrix(2, 2)).magnitude_above();
  const Vector3<Approximation> c0 = matrix.col(0);
  const Vector3<Approximation> c1 = matrix.col(1);
  const Vector3<Approximation> c2 = matrix.col(2);
  return trace * trace * trace / (4 * c0.dot(c1.cross(c2)).magnitude_below());
}

/// At least Σ_j |∂(N·V⁻)/∂x_j| |x_j|: N·v and N·(w × (P − X)) of each body, each product of components at most that of
/// the sums of their sizes.
double normal_velocity_sensitivity_above(const Collision& c) {
  const auto size = [](const Vector3<double>& vector) { return vector.lpNorm<1>(); };
  double sum = 0;
  for (const Body* body : {&c.a, &c.b}) {
    const double arms = 2 * size(lever_arm(*body, c.point)) + size(c.point) + size(body->position);
    sum += 2 * size(body->velocity) + size(body->angular_velocity) * arms;
  }
  return size(c.normal) * sum;
}

/// Σ_j |∂(N·V⁻)/∂x_j| |x_j|: the derivatives of N·(v + w × r) are V by N, N by v, r × N by w, and N × w by r = P − X.
double normal_velocity_sensitivity(const Collision& c) {
  // A number that is zero cannot be perturbed relatively, though its derivative be infinite.
  const auto weighted = [](const Vector3<double>& derivative, const Vector3<double>& x) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      sum += x[i] == 0 ? 0 : std::abs(derivative[i] * x[i]);
    }
    return sum;
  };
  double sum = weighted(relative_velocity<double>(c, unchanged(c)), c.normal);
  for (const Body* body : {&c.a, &c.b}) {
    sum += weighted(c.normal, body->velocity);
    sum += weighted(lever_arm(*body, c.point).cross(c.normal), body->angular_velocity);
    sum += weighted(c.normal.cross(body->angular_velocity), body->position);
  }
  return sum + weighted(c.normal.cross(c.a.angular_velocity - c.b.angular_velocity), c.point);
}

/// A number known to six digits, and so its sign (case_bounds.hpp).
bool is_known_to_six_digits(double normal_velocity, double sensitivity_above) {
  return std::abs(normal_velocity) > case_bounds::known_share_of_normal_velocity * sensitivity_above;
}
bool is_known_to_six_digits(const Enclosure& x) {
  return x.is_exactly_zero() || x.radius() < case_bounds::known_radius_of_normal_velocity * x.magnitude_below();
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

const DualInputs<double, collision_inputs>& ExactCase::differentiated() const {
  if (!differentiated_) {
    differentiated_ = std::make_unique<DualInputs<double, collision_inputs>>(
        dual_inputs<double, collision_inputs>(collision_, [](double x) { return x; }));
  }
  return *differentiated_;
}

const ExactCase::NormalVelocity& ExactCase::normal_velocity() const {
  if (!normal_velocity_) {
    const double roughly = normal_velocity_before(collision_);
    if (is_moderate() && is_known_to_six_digits(roughly, sensitivity_above_of_normal_velocity())) {
      normal_velocity_ = {roughly, roughly > 0 ? 1 : -1};
    } else if (const Enclosure closely = normal_velocity_before(enclosed()); is_known_to_six_digits(closely)) {
      normal_velocity_ = {closely.middle(), *closely.sign()};
    } else {
      const Rational exactly = normal_velocity_before(exact());
      normal_velocity_ = {to_double(exactly), sign_of(exactly)};
    }
  }
  return *normal_velocity_;
}

double ExactCase::sensitivity_above_of_normal_velocity() const {
  if (!sensitivity_above_of_normal_velocity_) {
    sensitivity_above_of_normal_velocity_ = normal_velocity_sensitivity_above(collision_);
  }
  return *sensitivity_above_of_normal_velocity_;
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
  if (is_moderate() && std::abs(normal_velocity().value) >
                           case_bounds::factor_for_grazing * allowance * sensitivity_above_of_normal_velocity()) {
    return false;
  }
  if (!normal_velocity_sensitivity_) {
    normal_velocity_sensitivity_ = normal_velocity_sensitivity(collision_);
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
      known = refined_truth(collision_, enclosed(), approximate(), model, approximate_response());
    }
    if (!known || !is_bounded(*known)) {
      known = truth_of(enclosed(), model, approach());
    }
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
  // Binary64 loses about κ(K) u of these sums: below 2²⁰ it keeps ten digits, above they are taken in enclosures, and
  // where these do not keep them either, in ℚ.
  constexpr double well_conditioned = 1 << 20;
  if (is_moderate() && condition_bound(approximate_collision_matrix()) < well_conditioned) {
    known = colliding_sensitivity(collision_, model);
  }
  if (!known) {
    known = enclosed_sensitivity(collision_, model);
  }
  if (!known) {
    known = exact_sensitivity(collision_, model);
  }
  return *known;
}

const Sensitivity& ExactCase::sensitivity_below(Model model) const {
  std::optional<Sensitivity>& known = of(model).sensitivity_below;
  if (known) {
    return *known;
  }
  known = norms_before();
  if (approach() == Approach::colliding) {
    const Vector3<Approximation> impulse =
        impulse_for<Approximation>(approximate(), model, wanted_change(approximate()), &approximate_response().matrix);
    const Outcome<Approximation> outcome = sum(unchanged(approximate()), approximate_response()(impulse));
    const auto parts = vectors(outcome);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Vector3<Approximation>& y = *parts[k];
      const double half =
          std::sqrt(y[0].magnitude_below() * y[0].magnitude_below() + y[1].magnitude_below() * y[1].magnitude_below() +
                    y[2].magnitude_below() * y[2].magnitude_below()) /
          2;
      (*known)[k] += std::isfinite(half) ? half : 0;
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
    const auto k = response_matrix(differentiated().collision);
    collision_matrix_sensitivity_ =
        sensitivity_of({&k(0, 0), &k(0, 1), &k(0, 2), &k(1, 0), &k(1, 1), &k(1, 2), &k(2, 0), &k(2, 1), &k(2, 2)},
                       differentiated().magnitude);
  }
  return *collision_matrix_sensitivity_;
}

const ApproximateResponse& ExactCase::approximate_response() const {
  if (!approximate_response_) {
    approximate_response_.emplace(approximate());
  }
  return *approximate_response_;
}

const Matrix3<Approximation>& ExactCase::approximate_collision_matrix() const { return approximate_response().matrix; }

Approximation ExactCase::approximate_inverse_mass() const { return inverse_mass_of(approximate()); }

const Enclosure& ExactCase::enclosed_inverse_mass() const {
  if (!enclosed_inverse_mass_) {
    enclosed_inverse_mass_ = inverse_mass_of(enclosed());
  }
  return *enclosed_inverse_mass_;
}

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
    collision_matrix_sensitivity_below_ =
        norm >= case_bounds::least_share_of_largest_terms * largest_terms ? std::max(norm, lambda) / 2 : lambda / 2;
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
  if (!is_collinear_) {
    const BasicCollision<Approximation>& near = approximate();
    const auto is_along_normal = [&](const BasicBody<Approximation>& body, const auto& exact_body) {
      return body.immovable || is_zero(lever_arm(body, near.point).cross(near.normal),
                                       [&] { return lever_arm(exact_body(), exact().point).cross(exact().normal); });
    };
    is_collinear_ = is_along_normal(
                        near.a, [&]() -> const auto& { return exact().a; }) &&
                    is_along_normal(
                        near.b, [&]() -> const auto& { return exact().b; });
  }
  return *is_collinear_;
}

bool ExactCase::is_head_on() const {
  if (!is_head_on_) {
    const BasicCollision<Approximation>& near = approximate();
    is_head_on_ = is_zero(near.normal.cross(relative_velocity<Approximation>(near, unchanged(near))), [&] {
      return exact().normal.cross(relative_velocity<Rational>(exact(), unchanged(exact())));
    });
  }
  return *is_head_on_;
}

const std::array<Matrix3<double>, 2>& ExactCase::inertia_tensors() const {
  if (!inertia_tensors_) {
    inertia_tensors_.emplace();
    const auto find = [](const Body& body, Matrix3<double>& tensor) {
      tensor.setZero();
      for (int i = 0; i < 3 && !body.immovable; ++i) {
        tensor.col(i) = apply_inertia<double>(body, Vector3<double>::Unit(i));
      }
    };
    find(collision_.a, (*inertia_tensors_)[0]);
    find(collision_.b, (*inertia_tensors_)[1]);
  }
  return *inertia_tensors_;
}

Rational ExactCase::inverse_mass() const { return inverse_mass_of(exact()); }

bool ExactCase::reads_impulse_off_a() const {
  return collision_.b.immovable || (!collision_.a.immovable && collision_.a.mass <= collision_.b.mass);
}

}  // namespace carom::oracles
