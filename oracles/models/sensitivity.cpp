// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <carom/oracles/models/models.hpp>
#include <carom/oracles/models/sensitivity.hpp>

namespace carom::oracles {
namespace {

/// The change that the law asks for, and its derivatives.
struct Wanted {
  Vector3<double> change;
  Jacobian derivative = Jacobian::Zero();
};

/// By the chain rule through the relative velocity before the impulse.
template <class Law>
Wanted wanted_of(const Collision& c, const Places& places) {
  Wanted result;
  Jacobian d_velocity = Jacobian::Zero();
  Vector3<double> velocity{0, 0, 0};
  const auto add_body = [&](const Body& body, const Places::OfBody& place, double sign) {
    constexpr std::size_t own = 9;  // position, velocity, angular velocity; and the contact point
    using T = Dual<double, own + 3>;
    const Vector3<T> arm = inputs<own + 3>(c.point, own) - inputs<own + 3>(body.position, 0);
    const Vector3<T> at_point =
        point_velocity<T>({inputs<own + 3>(body.velocity, 3), inputs<own + 3>(body.angular_velocity, 6)}, arm);
    velocity += sign * value(at_point);
    d_velocity.middleCols<own>(place.position) += sign * derivatives<own>(at_point, 0);
    d_velocity.middleCols<3>(places.point) += sign * derivatives<3>(at_point, own);
  };
  add_body(c.a, places.a, 1);
  add_body(c.b, places.b, -1);
  using T = Dual<double, 7>;  // normal, restitution, relative velocity
  const Vector3<T> wanted =
      Law::template wanted_change<T>(inputs<7>(c.normal, 0), T::input(c.restitution, 3), inputs<7>(velocity, 4));
  result.change = value(wanted);
  result.derivative = derivatives<3>(wanted, 4) * d_velocity;
  result.derivative.middleCols<4>(places.normal) += derivatives<4>(wanted, 0);
  return result;
}

/// Σ_j ‖∂y/∂x_j‖ |x_j|; not a number where squares may have left the range of binary64.
double weighted_norm(const Jacobian& jacobian, const Magnitudes& magnitude) {
  const double sum = (jacobian.array().square().colwise().sum().sqrt() * magnitude).sum();
  if (sum == 0 && (jacobian.array().abs().colwise().sum() * magnitude == 0).all()) {
    return 0;
  }
  return sum >= least_sum_by_squares && sum <= largest_sum_by_squares ? sum : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Sensitivity norms_before(const Collision& collision) { return norms_of(unchanged(collision)); }

std::optional<Sensitivity> colliding_sensitivity(const Collision& c, Model model) {
  const Places places(c);
  Derivatives derivatives = with_law(model, [&]<class Law>(Law) {
    const Wanted wanted = wanted_of<Law>(c, places);
    const Vector3<double> impulse = Law::template impulse_for<double>(c, wanted.change, nullptr);
    const BodyResponse a = response_of(c.a, c.point, impulse, places.a, places.point);
    const BodyResponse b = response_of(c.b, c.point, -impulse, places.b, places.point);
    const Jacobian left = a.d_at_point - b.d_at_point - wanted.derivative;
    return Law::derivatives(c, {a, b, impulse, wanted.change, left, places.normal});
  });
  const PerVector<Eigen::Index> before{places.a.velocity(), places.a.angular_velocity(), places.b.velocity(),
                                       places.b.angular_velocity()};
  Sensitivity result = norms_before(c);
  for (const OutcomeVector k : all_outcome_vectors) {
    derivatives[k].middleCols<3>(before[k]) += Matrix3<double>::Identity();
    result[k] += weighted_norm(derivatives[k], places.magnitude);
  }
  const bool is_known = std::all_of(result.begin(), result.end(), [](double sum) { return std::isfinite(sum); });
  return is_known ? std::optional<Sensitivity>(result) : std::nullopt;
}

std::optional<Sensitivity> enclosed_sensitivity(const Collision& collision, Model model) {
  using T = Dual<Enclosure, collision_inputs>;
  const auto inputs = dual_inputs<Enclosure, collision_inputs>(collision, [](double x) { return Enclosure(x); });
  const Truth<T> truth = colliding_truth(inputs.collision, model);
  Sensitivity result = norms_before(collision);
  const auto parts = vectors(truth.outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    double unknown = 0;
    for (int i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < inputs.magnitude.size(); ++j) {
        const double radius = (*parts[k])[i].derivative[j].radius();
        unknown += inputs.magnitude[j] == 0 ? 0 : radius * inputs.magnitude[j];
      }
    }
    result[k] += sensitivity_of({&(*parts[k])[0], &(*parts[k])[1], &(*parts[k])[2]}, inputs.magnitude);
    // Written so that what is no number is not known.
    if (!(unknown <= ten_digits * result[k]) || !std::isfinite(result[k])) {
      return std::nullopt;
    }
  }
  return result;
}

Sensitivity exact_sensitivity(const Collision& collision, Model model) {
  const auto inputs = dual_inputs<Rational, collision_inputs>(collision, [](double x) { return Rational(x); });
  const auto truth = colliding_truth(inputs.collision, model);
  Sensitivity result = norms_before(collision);
  const auto parts = vectors(truth.outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    result[k] += sensitivity_of({&(*parts[k])[0], &(*parts[k])[1], &(*parts[k])[2]}, inputs.magnitude);
  }
  return result;
}

}  // namespace carom::oracles
