// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/collision/expects.hpp>
#include <carom/oracles/filters/bounded_case.hpp>
#include <carom/oracles/filters/bounded_case_bounds.hpp>
#include <carom/oracles/filters/moderate.hpp>
#include <carom/oracles/models/models.hpp>
#include <carom/oracles/numbers/norm.hpp>

namespace carom::oracles {
namespace {

/// An upper bound of the condition number e₁ / e₃ of a symmetric positive definite matrix with eigenvalues e₁ ≥ e₂ ≥ e₃
/// and trace t. e₁ ≤ t, and e₁ e₂ ≤ (t/2)². So e₁ / e₃ = e₁ · e₁ e₂ / det ≤ t³ / (4 det).
double condition_bound(const Matrix3<Approximation>& matrix) {
  const double trace = (matrix(0, 0) + matrix(1, 1) + matrix(2, 2)).magnitude_above();
  const Vector3<Approximation> c0 = matrix.col(0);
  const Vector3<Approximation> c1 = matrix.col(1);
  const Vector3<Approximation> c2 = matrix.col(2);
  return trace * trace * trace / (4 * c0.dot(c1.cross(c2)).magnitude_below());
}

/// An upper bound of Σ_q ‖∂(N·V⁻)/∂q‖ ‖q‖, and of Σ|t| over the terms t of N·V⁻. The terms are N·v and N·(w × (P − X))
/// of each body. |x·y| and ‖x × y‖ are at most ‖x‖₁ ‖y‖₁.
double sum_of_sizes(const Collision& c) {
  const auto size = [](const Vector3<double>& vector) { return vector.lpNorm<1>(); };
  double sum = 0;
  for (const Body* body : {&c.a, &c.b}) {
    const double arms = 2 * size(lever_arm(*body, c.point)) + size(c.point) + size(body->position) + extent_of(*body);
    sum += 2 * size(body->velocity) + size(body->angular_velocity) * arms;
  }
  return size(c.normal) * sum;
}

/// Whether N·V⁻, and so its sign, is known to six digits (bounded_case_bounds.hpp).
bool is_known_to_six_digits(double normal_velocity, double sensitivity_above) {
  return std::abs(normal_velocity) > bounded_case_bounds::known_share_of_normal_velocity * sensitivity_above;
}
bool is_known_to_six_digits(const Enclosure& x) {
  return x.is_exactly_zero() || x.radius() < bounded_case_bounds::known_radius_of_normal_velocity * x.magnitude_below();
}

Vector3<double> middle(const Vector3<Enclosure>& v) {
  return v.unaryExpr([](const Enclosure& x) { return x.middle(); });
}

/// The Frobenius norm of the lower bounds of the entries.
template <int Columns>
double norm_below(const Eigen::Matrix<Approximation, 3, Columns>& of) {
  return root_of_squares(static_cast<std::size_t>(of.size()),
                         [&](std::size_t i) { return of.data()[i].magnitude_below(); });
}

}  // namespace

const BasicCollision<Enclosure>& BoundedCase::enclosed() const {
  return enclosed_.get(
      [this] { return map_numbers<Enclosure>(collision_, [](double number) { return Enclosure(number); }); });
}

const BasicCollision<Approximation>& BoundedCase::approximate() const {
  return approximate_.get(
      [this] { return map_numbers<Approximation>(collision_, [](double number) { return Approximation(number); }); });
}

bool BoundedCase::is_moderate() const {
  return is_moderate_.get([this] { return oracles::is_moderate(collision_); });
}

std::optional<BoundedCase::NormalVelocity> BoundedCase::normal_velocity() const {
  const double roughly = normal_velocity_before(collision_);
  if (is_moderate() && is_known_to_six_digits(roughly, normal_velocity_sensitivity_above())) {
    return NormalVelocity{roughly, roughly > 0 ? 1 : -1};
  }
  if (const Enclosure closely = normal_velocity_before(enclosed()); is_known_to_six_digits(closely)) {
    return NormalVelocity{closely.middle(), *closely.sign()};
  }
  return std::nullopt;
}

const Vector3<double>& BoundedCase::relative_velocity() const {
  return relative_velocity_.get(
      [this] { return middle(oracles::relative_velocity<Enclosure>(enclosed(), unchanged(enclosed()))); });
}

const BoundedCase::StopImpulses& BoundedCase::stop_impulses() const {
  return stop_impulses_.get([this] {
    const detail::RoughImpulses<Enclosure> of(enclosed(), nullptr);
    return StopImpulses{middle(of.stops_approach), middle(of.stops_point)};
  });
}

double BoundedCase::normal_velocity_sensitivity_above() const {
  return normal_velocity_sensitivity_above_.get([this] { return sum_of_sizes(collision_); });
}

const Sensitivity& BoundedCase::norms_before() const {
  return norms_before_.get([this] { return oracles::norms_before(collision_); });
}

const DualInputs<double, collision_inputs>& BoundedCase::differentiated() const {
  return *differentiated_.get([this] {
    return std::make_unique<DualInputs<double, collision_inputs>>(
        dual_inputs<double, collision_inputs>(collision_, [](double x) { return x; }));
  });
}

const Truth<Enclosure>& BoundedCase::colliding_truth(Law law, Branch branch) const {
  return of(law).truth.get([&] {
    if (is_moderate()) {
      Truth<Enclosure> refined =
          refined_truth(collision_, enclosed(), approximate(), law, branch, approximate_response());
      if (is_bounded(refined)) {
        return refined;
      }
    }
    return oracles::colliding_truth(enclosed(), law, branch);
  });
}

const Sensitivity& BoundedCase::colliding_sensitivity_below(Law law, Branch branch) const {
  CAROM_EXPECTS(is_moderate() && (branch != Branch::on_cone || has_clear_divisor()), law);
  return of(law).sensitivity_below.get([&] {
    Sensitivity below = norms_before();
    const Vector3<Approximation> impulse =
        colliding_impulse<Approximation>(approximate(), law, branch, &approximate_response().matrix);
    const Outcome<Approximation> outcome = sum(unchanged(approximate()), approximate_response()(impulse));
    for (const OutcomeVector k : all_outcome_vectors) {
      below[k] += norm_below(*vectors(outcome)[k]) / 2;
    }
    return below;
  });
}

std::optional<bool> BoundedCase::is_inside_cone() const {
  const auto sign = [](const auto& x) { return x.sign(); };
  const std::optional<bool> roughly = oracles::is_inside_cone(approximate(), &approximate_response().matrix, sign);
  return roughly ? roughly : oracles::is_inside_cone<Enclosure>(enclosed(), nullptr, sign);
}

std::optional<bool> BoundedCase::reaches_cone() const {
  const auto sign = [](const auto& x) { return x.sign(); };
  const std::optional<bool> roughly = oracles::reaches_cone(approximate(), &approximate_response().matrix, sign);
  return roughly ? roughly : oracles::reaches_cone<Enclosure>(enclosed(), nullptr, sign);
}

bool BoundedCase::has_clear_divisor() const {
  CAROM_EXPECTS(is_moderate());
  return has_clear_divisor_.get([this] {
    const BasicCollision<Approximation>& c = approximate();
    const Vector3<Approximation> d =
        detail::RoughImpulses<Approximation>(c, &approximate_response().matrix).difference();
    const Vector3<Approximation> tangential = c.normal.cross(d);
    const double terms = sqrt(Approximation(tangential.dot(tangential))).magnitude_above() +
                         (c.friction * c.normal.dot(d)).magnitude_above();
    return Rough::divisor<Approximation>(c, d).magnitude_below() >= bounded_case_bounds::least_share_of_divisor * terms;
  });
}

bool BoundedCase::is_well_conditioned() const {
  constexpr double well_conditioned = 1 << 20;
  return condition_bound(collision_matrix()) < well_conditioned;
}

const Matrix3<Enclosure>& BoundedCase::enclosed_collision_matrix() const {
  return enclosed_collision_matrix_.get([this] { return response_matrix(enclosed()); });
}

double BoundedCase::collision_matrix_sensitivity_below() const {
  CAROM_EXPECTS(is_moderate());
  return collision_matrix_sensitivity_below_.get([this] {
    double largest_terms{};
    for (const Body* body : {&collision_.a, &collision_.b}) {
      if (!body->immovable) {
        largest_terms += lever_arm(*body, collision_.point).squaredNorm() / body->principal_inertia.minCoeff();
      }
    }
    const double norm = norm_below(collision_matrix());
    const double lambda = approximate_inverse_mass().magnitude_below();
    return norm >= bounded_case_bounds::least_share_of_largest_terms * largest_terms ? std::max(norm, lambda) / 2
                                                                                     : lambda / 2;
  });
}

const ApproximateResponse& BoundedCase::approximate_response() const {
  return approximate_response_.get([this] { return ApproximateResponse(approximate()); });
}

}  // namespace carom::oracles
