// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <carom/oracles/filters/closeness.hpp>
#include <carom/oracles/filters/closeness_bounds.hpp>

namespace carom::oracles {

Closeness::Closeness(const ExactCase& exact_case, const LiftedOutcome& outcome, const Accuracy& accuracy,
                     double allowance)
    : exact_case_(&exact_case), outcome_(&outcome), error_above_(accuracy.error_above), allowance_(allowance) {
  const std::array<double, 4> norms = outcome.norms();
  for (std::size_t k = 0; k < is_close_.size(); ++k) {
    sizes_[k] = norms[k] + exact_case.norms_before()[k];
    is_close_[k] =
        error_above_[k] == 0 || (error_above_[k] <= (1 - closeness_bounds::set_aside) * allowance * sizes_[k] &&
                                 sizes_[k] >= closeness_bounds::least_size);
  }
}

bool Closeness::is_close(std::initializer_list<std::size_t> which) const {
  return std::all_of(which.begin(), which.end(), [&](std::size_t k) { return is_close_[k]; });
}

bool Closeness::shows(AffineLaw law) const {
  switch (law) {
    case AffineLaw::linear_momentum:
      return is_close({0, 2});
    case AffineLaw::angular_momentum_of_a:
    case AffineLaw::untouched_a:
      return is_close({0, 1});
    case AffineLaw::angular_momentum_of_b:
    case AffineLaw::untouched_b:
      return is_close({2, 3});
    case AffineLaw::total_angular_momentum:
    case AffineLaw::reflection_plane:
      return is_close({0, 1, 2, 3});
    case AffineLaw::restitution:
    case AffineLaw::non_penetration:
      return is_close({0, 1, 2, 3}) && knows_normal_velocity();
    case AffineLaw::push:
    case AffineLaw::frictionless_direction:
      return exact_case_ != nullptr && is_close_[exact_case_->reads_impulse_off_a() ? 0 : 2];
  }
  return false;
}

/// N·V⁺ has the slopes ‖N‖ by velocities and ‖r × N‖ by angular velocities. The latter cancels where r is along N.
bool Closeness::knows_normal_velocity() const {
  const Collision& c = exact_case_->collision();
  const double normal = c.normal.norm();
  double scale = normal * (sizes_[0] + sizes_[2]);
  double noise = 0;
  const auto add_arm = [&](const Body& body, double size) {
    const Vector3<double> arm = lever_arm(body, c.point);
    scale += arm.cross(c.normal).norm() * size;
    noise += closeness_bounds::noise_of_moment * arm.norm() * normal * size;
  };
  add_arm(c.a, sizes_[1]);
  add_arm(c.b, sizes_[3]);
  return noise <= closeness_bounds::share_for_noise * scale;
}

/// E⁺ − W has the slopes ‖m (v̂ − u)‖, u the velocity of a driven wall at the contact point, and ‖J ŵ‖. They cancel
/// where the body is nearly at rest after the impulse, or moves along with the wall.
bool Closeness::shows_energy() const {
  if (exact_case_ == nullptr) {
    return false;
  }
  const Collision& c = exact_case_->collision();
  double scale = 0;
  double noise = 0;
  const auto add_body = [&](const Body& body, const BodyVelocity<double>& after, const Body& other,
                            const Matrix3<double>& inertia, std::size_t k) {
    if (body.immovable) {
      return true;
    }
    Vector3<double> relative = after.velocity;
    double terms = sizes_[k];
    if (other.immovable) {
      const Vector3<double> arm = lever_arm(other, c.point);
      relative -= point_velocity<double>({other.velocity, other.angular_velocity}, arm);
      terms += other.velocity.norm() + other.angular_velocity.norm() * arm.norm();
    }
    scale += body.mass * relative.norm() * sizes_[k];
    noise += closeness_bounds::noise_of_energy_slope * body.mass * terms * sizes_[k];
    scale += (inertia * after.angular_velocity).norm() * sizes_[k + 1];
    noise +=
        closeness_bounds::noise_of_energy_slope * body.principal_inertia.maxCoeff() * sizes_[k + 1] * sizes_[k + 1];
    return is_close({k, k + 1});
  };
  const Outcome<double>& after = outcome_->rounded();
  // Where every error is zero, nothing is missed; else the scale has to be a number.
  const bool is_exact = std::all_of(error_above_.begin(), error_above_.end(), [](double above) { return above == 0; });
  return add_body(c.a, after.a, c.b, exact_case_->inertia_of_a(), 0) &&
         add_body(c.b, after.b, c.a, exact_case_->inertia_of_b(), 2) &&
         (is_exact ||
          (noise <= closeness_bounds::share_for_noise * scale && scale >= closeness_bounds::least_scale_of_energy));
}

bool Closeness::shows_untouched(std::initializer_list<std::size_t> which) const {
  return exact_case_ != nullptr && std::all_of(which.begin(), which.end(), [&](std::size_t k) {
           return error_above_[k] <= (1 - closeness_bounds::set_aside) * allowance_ * exact_case_->norms_before()[k];
         });
}

}  // namespace carom::oracles
