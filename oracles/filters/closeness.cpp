// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/collision/expects.hpp>
#include <carom/oracles/filters/closeness.hpp>
#include <carom/oracles/filters/closeness_bounds.hpp>
#include <carom/oracles/filters/slopes.hpp>
#include <carom/oracles/models/models.hpp>

namespace carom::oracles {
Closeness::Closeness(const BoundedCase& bounds, Law law, const LiftedOutcome& outcome,
                     const PerVector<double>& error_above, double allowance)
    : bounds_(&bounds), law_(law), outcome_(&outcome), error_above_(error_above), allowance_(allowance) {
  CAROM_EXPECTS(determines_outcome(law) && bounds.is_moderate() && outcome.is_moderate() && allowance > 0, law,
                allowance);
  const PerVector<double> norms = outcome.norms();
  for (const OutcomeVector k : all_outcome_vectors) {
    sizes_[k] = norms[k] + bounds.norms_before()[k];
    is_close_[k] =
        error_above_[k] == 0 || (error_above_[k] <= (1 - closeness_bounds::set_aside) * allowance * sizes_[k] &&
                                 sizes_[k] >= closeness_bounds::least_size);
  }
}

bool Closeness::shows(const Equation& equation) const {
  const std::optional<AffineEquation> name = name_of(equation);
  if (bounds_ == nullptr || !name || !keeps(law_, *name)) {
    return false;
  }
  const PerVector<bool>& occurs = vectors_in(*name);
  for (const OutcomeVector k : all_outcome_vectors) {
    if (occurs[k] && !is_close_[k]) {
      return false;
    }
  }
  return !is_of_normal_velocity(*name) || knows_normal_velocity();
}

/// The slopes of N·V⁺ are ‖N‖ for velocities and ‖r × N‖ for angular velocities. The terms of r × N cancel if r is
/// along N.
bool Closeness::knows_normal_velocity() const {
  const Collision& c = bounds_->collision();
  const double normal = c.normal.norm();
  double scale = normal * (sizes_[OutcomeVector::velocity_of_a] + sizes_[OutcomeVector::velocity_of_b]);
  double noise = 0;
  const auto add_arm = [&](const Body& body, double size) {
    const Vector3<double> arm = lever_arm(body, c.point);
    scale += arm.cross(c.normal).norm() * size;
    noise += closeness_bounds::noise_of_moment * arm.norm() * normal * size;
  };
  add_arm(c.a, sizes_[OutcomeVector::angular_velocity_of_a]);
  add_arm(c.b, sizes_[OutcomeVector::angular_velocity_of_b]);
  return noise <= closeness_bounds::share_for_noise * scale;
}

/// For a movable body with the velocities v̂ and ŵ after the impulse, the slopes of E⁺ − W (equation::Energy) are
/// ‖m (v̂ − u)‖ and ‖J ŵ‖. If the other body is immovable, u is its velocity at the contact point, otherwise 0. The
/// slopes cancel if the body is nearly at rest after the impulse, or moves with the other body.
bool Closeness::shows_energy() const {
  if (bounds_ == nullptr || !creates_no_energy(law_)) {
    return false;
  }
  const Collision& c = bounds_->collision();
  double scale = 0;
  double noise = 0;
  const auto add_body = [&](const Body& body, const BodyVelocity<double>& after, const Body& other,
                            const Matrix3<double>& inertia, OutcomeVector v, OutcomeVector w) {
    if (body.immovable) {
      return true;
    }
    Vector3<double> relative = after.velocity;
    double terms = sizes_[v];
    if (other.immovable) {
      const Vector3<double> arm = lever_arm(other, c.point);
      relative -= point_velocity<double>({other.velocity, other.angular_velocity}, arm);
      terms += other.velocity.norm() + other.angular_velocity.norm() * arm.norm();
    }
    scale += body.mass * relative.norm() * sizes_[v];
    noise += closeness_bounds::noise_of_energy_slope * body.mass * terms * sizes_[v];
    scale += (inertia * after.angular_velocity).norm() * sizes_[w];
    noise += closeness_bounds::noise_of_energy_slope * body.principal_inertia.maxCoeff() * sizes_[w] * sizes_[w];
    return is_close_[v] && is_close_[w];
  };
  const Outcome<double>& after = outcome_->rounded();
  // If every error is 0, the outcome is the truth, and the equation holds. Otherwise the scale must be large enough for
  // `compare`.
  const bool is_exact = std::all_of(error_above_.begin(), error_above_.end(), [](double above) { return above == 0; });
  return add_body(c.a, after.a, c.b, bounds_->inertia_of_a(), OutcomeVector::velocity_of_a,
                  OutcomeVector::angular_velocity_of_a) &&
         add_body(c.b, after.b, c.a, bounds_->inertia_of_b(), OutcomeVector::velocity_of_b,
                  OutcomeVector::angular_velocity_of_b) &&
         (is_exact ||
          (noise <= closeness_bounds::share_for_noise * scale && scale >= closeness_bounds::least_scale_of_energy));
}

bool Closeness::shows_untouched(std::span<const OutcomeVector> which) const {
  return bounds_ != nullptr && std::all_of(which.begin(), which.end(), [&](OutcomeVector k) {
           return error_above_[k] <= (1 - closeness_bounds::set_aside) * allowance_ * bounds_->norms_before()[k];
         });
}

}  // namespace carom::oracles
