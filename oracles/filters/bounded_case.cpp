// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <type_traits>

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
double condition_bound(const Matrix3<Enclosure>& matrix) {
  const double trace = (matrix(0, 0) + matrix(1, 1) + matrix(2, 2)).magnitude_above();
  const Vector3<Enclosure> c0 = matrix.col(0);
  const Vector3<Enclosure> c1 = matrix.col(1);
  const Vector3<Enclosure> c2 = matrix.col(2);
  return trace * trace * trace / (4 * c0.dot(c1.cross(c2)).magnitude_below());
}

/// Whether N·V⁻, and so its sign, is known to six digits.
bool is_known_to_six_digits(const Enclosure& x) {
  return x.is_exactly_zero() || x.radius() < bounded_case_bounds::known_radius_of_normal_velocity * x.magnitude_below();
}

Vector3<double> middle(const Vector3<Enclosure>& v) {
  return v.unaryExpr([](const Enclosure& x) { return x.middle(); });
}

/// The Frobenius norm of the lower bounds of the entries.
template <int Columns>
double norm_below(const Eigen::Matrix<Enclosure, 3, Columns>& of) {
  return root_of_squares(static_cast<std::size_t>(of.size()),
                         [&](std::size_t i) { return of.data()[i].magnitude_below(); });
}

}  // namespace

const BasicCollision<Enclosure>& BoundedCase::enclosed() const {
  return enclosed_.get(
      [this] { return map_numbers<Enclosure>(collision_, [](double number) { return Enclosure(number); }); });
}

bool BoundedCase::is_moderate() const {
  return is_moderate_.get([this] { return oracles::is_moderate(collision_); });
}

std::optional<BoundedCase::NormalVelocity> BoundedCase::normal_velocity() const {
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
    const detail::RoughImpulses<Enclosure> of(enclosed(), &collision_matrix());
    return StopImpulses{middle(of.stops_approach), middle(of.stops_point)};
  });
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
  return of(law).truth[branch].get([&] {
    // An impulse along N needs K N alone. The sum over columns of K would cancel if a lever arm is along N.
    const bool is_along_normal =
        with_law(law, branch, []<class LawType>(LawType) { return std::is_same_v<LawType, Frictionless>; });
    return oracles::colliding_truth(enclosed(), law, branch, is_along_normal ? nullptr : &collision_matrix());
  });
}

const Sensitivity& BoundedCase::colliding_sensitivity_below(Law law, Branch branch) const {
  CAROM_EXPECTS(is_moderate() && (branch != Branch::on_cone || has_clear_divisor()), law);
  return of(law).sensitivity_below[branch].get([&] {
    Sensitivity below = norms_before();
    const Outcome<Enclosure>& outcome = colliding_truth(law, branch).outcome;
    for (const OutcomeVector k : all_outcome_vectors) {
      below[k] += norm_below(*vectors(outcome)[k]) / 2;
    }
    return below;
  });
}

std::optional<bool> BoundedCase::is_inside_cone() const {
  return oracles::is_inside_cone(enclosed(), &collision_matrix(), [](const Enclosure& x) { return x.sign(); });
}

std::optional<bool> BoundedCase::reaches_cone() const {
  return oracles::reaches_cone(enclosed(), &collision_matrix(), [](const Enclosure& x) { return x.sign(); });
}

bool BoundedCase::has_clear_divisor() const {
  CAROM_EXPECTS(is_moderate());
  return has_clear_divisor_.get([this] {
    const BasicCollision<Enclosure>& c = enclosed();
    const Vector3<Enclosure> d = detail::RoughImpulses<Enclosure>(c, &collision_matrix()).difference();
    const Vector3<Enclosure> tangential = c.normal.cross(d);
    const double terms = sqrt(Enclosure(tangential.dot(tangential))).magnitude_above() +
                         (c.friction * c.normal.dot(d)).magnitude_above();
    return Rough::divisor<Enclosure>(c, d).magnitude_below() >= bounded_case_bounds::least_share_of_divisor * terms;
  });
}

bool BoundedCase::is_well_conditioned() const {
  constexpr double well_conditioned = 1 << 20;
  return condition_bound(collision_matrix()) < well_conditioned;
}

const Matrix3<Enclosure>& BoundedCase::collision_matrix() const {
  return collision_matrix_.get([this] { return response_matrix(enclosed()); });
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
    const double lambda = inverse_mass(enclosed()).magnitude_below();
    return norm >= bounded_case_bounds::least_share_of_largest_terms * largest_terms ? std::max(norm, lambda) / 2
                                                                                     : lambda / 2;
  });
}

}  // namespace carom::oracles
