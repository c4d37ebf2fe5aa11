// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <carom/oracles/models/models.hpp>
#include <carom/oracles/models/sensitivity.hpp>

namespace carom::oracles {
namespace {

/// The change that the law asks for, and its derivatives.
struct Wanted {
  Vector3<double> change;
  Jacobian derivative = Jacobian::Zero();
};

/// By the chain rule through the relative velocity before the impulse. `restitution` is ε, with or without a
/// derivative.
template <class Law>
Wanted wanted_of(const Collision& c, const Places& places, const Dual<double, 7>& restitution) {
  Wanted result;
  Jacobian d_velocity = Jacobian::Zero();
  // Of what cancels in V⁻ the direction of the slip is made.
  const auto enclosed = map_numbers<Enclosure>(c, [](double x) { return Enclosure(x); });
  const Vector3<double> velocity =
      relative_velocity<Enclosure>(enclosed, unchanged(enclosed)).unaryExpr([](const Enclosure& x) {
        return x.middle();
      });
  const auto add_body = [&](const Body& body, const Places::OfBody& place, double sign) {
    constexpr std::size_t own = 9;  // position, velocity, angular velocity; and the contact point
    using T = Dual<double, own + 3>;
    const Vector3<T> arm = inputs<own + 3>(c.point, own) - inputs<own + 3>(body.position, 0);
    const Vector3<T> at_point =
        point_velocity<T>({inputs<own + 3>(body.velocity, 3), inputs<own + 3>(body.angular_velocity, 6)}, arm);
    d_velocity.middleCols<own>(place.position) += sign * derivatives<own>(at_point, 0);
    d_velocity.middleCols<3>(places.point) += sign * derivatives<3>(at_point, own);
  };
  add_body(c.a, places.a, 1);
  add_body(c.b, places.b, -1);
  using T = Dual<double, 7>;  // normal, restitution, relative velocity
  const Vector3<T> wanted = Law::template wanted_change<T>(inputs<7>(c.normal, 0), restitution, inputs<7>(velocity, 4));
  result.change = value(wanted);
  result.derivative = derivatives<3>(wanted, 4) * d_velocity;
  result.derivative.middleCols<4>(places.normal) += derivatives<4>(wanted, 0);
  return result;
}

/// A linear law's impulse and what it adds to the velocities, with their derivatives.
struct Differentiated {
  Vector3<double> impulse;
  PerVector<Vector3<double>> change;
  Derivatives derivatives;
};

template <class Law>
Differentiated differentiated(const Collision& c, const Places& places, const Dual<double, 7>& restitution) {
  const Wanted wanted = wanted_of<Law>(c, places, restitution);
  const Vector3<double> impulse = Law::template impulse_for<double>(c, wanted.change, nullptr);
  const BodyResponse a = response_of(c.a, c.point, impulse, places.a, places.point);
  const BodyResponse b = response_of(c.b, c.point, -impulse, places.b, places.point);
  const Jacobian left = a.d_at_point - b.d_at_point - wanted.derivative;
  return {impulse,
          {a.velocity * impulse, a.angular_velocity * impulse, -b.velocity * impulse, -b.angular_velocity * impulse},
          Law::derivatives(c, {a, b, impulse, wanted.change, left, places.normal})};
}

using Row = Eigen::Matrix<double, 1, collision_inputs>;

/// κ of `rough`, and its derivatives.
struct Share {
  double value = 0;
  Row derivative = Row::Zero();
};

Share friction_share(const Collision& c, const Places& places, const Differentiated& approach,
                     const Differentiated& point, Branch branch) {
  const Vector3<double> d = point.impulse - approach.impulse;
  Share share{Rough::friction_share<double>(c, approach.impulse, d, branch)};
  if (branch == Branch::inside_cone) {
    share.derivative[places.tangential_restitution()] = 1;
    return share;
  }
  // κ q = μ (1 + ε) p with p = N·P_I and q = ‖N × D‖ − μ N·D.
  const Jacobian d_of_d = point.derivatives.of_impulse - approach.derivatives.of_impulse;
  const Vector3<double>& n = c.normal;
  const Vector3<double> tangential = n.cross(d);
  const Vector3<double> along = tangential.normalized();
  const double p = n.dot(approach.impulse);
  const double q = Rough::divisor<double>(c, d);
  // ∂(N·D) and ∂‖N × D‖ = t·(∂N × D + N × ∂D), t along N × D.
  Row d_normal = n.transpose() * d_of_d;
  d_normal.segment<3>(places.normal) += d.transpose();
  Row d_tangential = along.cross(n).transpose() * d_of_d;
  d_tangential.segment<3>(places.normal) += d.cross(along).transpose();
  Row d_p = n.transpose() * approach.derivatives.of_impulse;
  d_p.segment<3>(places.normal) += approach.impulse.transpose();
  Row numerator = c.friction * (1 + c.restitution) * d_p;
  numerator[places.friction()] += (1 + c.restitution) * p;
  numerator[places.restitution()] += c.friction * p;
  Row d_q = d_tangential - c.friction * d_normal;
  d_q[places.friction()] -= n.dot(d);
  share.derivative = (numerator - share.value * d_q) / q;
  return share;
}

/// The derivatives of what the law's impulse adds to the velocities.
template <class Law>
PerVector<Jacobian> change_derivatives(const Collision& c, const Places& places, Branch branch) {
  using T = Dual<double, 7>;
  if constexpr (LinearLaw<Law>) {
    return differentiated<Law>(c, places, T::input(c.restitution, 3)).derivatives.of_change;
  } else {
    const Differentiated approach = differentiated<typename Law::StopsApproach>(c, places, T(0));
    const Differentiated point = differentiated<typename Law::StopsPoint>(c, places, T(0));
    const Share share = friction_share(c, places, approach, point, branch);
    PerVector<Jacobian> result;
    for (const OutcomeVector k : all_outcome_vectors) {
      const Jacobian& of_approach = approach.derivatives.of_change[k];
      result[k] = (1 + c.restitution) * of_approach + share.value * (point.derivatives.of_change[k] - of_approach) +
                  (point.change[k] - approach.change[k]) * share.derivative;
      result[k].col(places.restitution()) += approach.change[k];
    }
    return result;
  }
}

/// Σ_q ‖∂y/∂q‖ ‖q‖; not a number where squares may have left the range of binary64.
double weighted_norm(const Jacobian& jacobian, const std::vector<Quantity>& quantities) {
  double sum = 0;
  bool is_zero = true;
  for (const Quantity& q : quantities) {
    const auto of_quantity =
        jacobian.middleCols(static_cast<Eigen::Index>(q.first), static_cast<Eigen::Index>(q.count));
    sum += of_quantity.norm() * q.length;
    is_zero = is_zero && (q.length == 0 || of_quantity.isZero(0));
  }
  if (is_zero) {
    return 0;
  }
  return sum >= least_sum_by_squares && sum <= largest_sum_by_squares ? sum : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Sensitivity norms_before(const Collision& collision) { return norms_of(unchanged(collision)); }

std::optional<Sensitivity> colliding_sensitivity(const Collision& c, Model model, Branch branch) {
  const Places places(c);
  PerVector<Jacobian> derivatives =
      with_law(model, branch, [&]<class Law>(Law) { return change_derivatives<Law>(c, places, branch); });
  const PerVector<Eigen::Index> before{places.a.velocity(), places.a.angular_velocity(), places.b.velocity(),
                                       places.b.angular_velocity()};
  Sensitivity result = norms_before(c);
  for (const OutcomeVector k : all_outcome_vectors) {
    derivatives[k].middleCols<3>(before[k]) += Matrix3<double>::Identity();
    result[k] += weighted_norm(derivatives[k], places.quantities);
  }
  const bool is_known = std::all_of(result.begin(), result.end(), [](double sum) { return std::isfinite(sum); });
  return is_known ? std::optional<Sensitivity>(result) : std::nullopt;
}

std::optional<Sensitivity> enclosed_sensitivity(const Collision& collision, Model model, Branch branch) {
  using T = Dual<Enclosure, collision_inputs>;
  const auto inputs = dual_inputs<Enclosure, collision_inputs>(collision, [](double x) { return Enclosure(x); });
  const Truth<T> truth = colliding_truth(inputs.collision, model, branch);
  Sensitivity result = norms_before(collision);
  const auto parts = vectors(truth.outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    const auto radius = [&](std::size_t i, std::size_t j) {
      return (*parts[k])[static_cast<Eigen::Index>(i)].derivative[j].radius();
    };
    const double unknown = sum_over_quantities(inputs.quantities, 3, radius);
    result[k] += sensitivity_of({&(*parts[k])[0], &(*parts[k])[1], &(*parts[k])[2]}, inputs.quantities);
    // Written so that what is no number is not known. Exact derivatives take a hundred times as long.
    constexpr double thousandth = 0x1p-10;
    if (!(unknown <= thousandth * result[k]) || !std::isfinite(result[k])) {
      return std::nullopt;
    }
  }
  return result;
}

namespace {

Sensitivity sensitivity_of_outcome(const Collision& collision, const auto& outcome,
                                   const std::vector<Quantity>& quantities) {
  Sensitivity result = norms_before(collision);
  const auto parts = vectors(outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    result[k] += sensitivity_of({&(*parts[k])[0], &(*parts[k])[1], &(*parts[k])[2]}, quantities);
  }
  return result;
}

using RationalDual = Dual<Rational, collision_inputs>;
using RadicalDual = Dual<Radical, collision_inputs>;

RadicalDual lifted(const RationalDual& x) {
  RadicalDual result(Radical(x.value));
  for (std::size_t i = 0; i < collision_inputs; ++i) {
    result.derivative[i] = Radical(x.derivative[i]);
  }
  return result;
}

/// The answer of `rough` on the cone: in ℚ but for what has the root in it.
Outcome<RadicalDual> answer_on_cone(const BasicCollision<RationalDual>& c) {
  const auto lift = [](const Vector3<RationalDual>& v) {
    return Vector3<RadicalDual>{lifted(v[0]), lifted(v[1]), lifted(v[2])};
  };
  const detail::RoughImpulses<RationalDual> of(c, nullptr);
  const Outcome<RationalDual> by_approach = response<RationalDual>(c, of.stops_approach);
  const Outcome<RationalDual> by_friction = response<RationalDual>(c, of.difference());
  const auto in_radicals = map_numbers<RadicalDual>(c, [](const RationalDual& x) { return lifted(x); });
  const RadicalDual share =
      Rough::friction_share<RadicalDual>(in_radicals, lift(of.stops_approach), lift(of.difference()), Branch::on_cone);
  Outcome<RadicalDual> answer = unchanged(in_radicals);
  for (const OutcomeVector k : all_outcome_vectors) {
    *vectors(answer)[k] += Rough::combined<RadicalDual>(in_radicals, lift(*vectors(by_approach)[k]),
                                                        lift(*vectors(by_friction)[k]), share);
  }
  return answer;
}

}  // namespace

Sensitivity exact_sensitivity(const Collision& collision, Model model, Branch branch) {
  const auto inputs = dual_inputs<Rational, collision_inputs>(collision, [](double x) { return Rational(x); });
  if (branch == Branch::on_cone) {
    return sensitivity_of_outcome(collision, answer_on_cone(inputs.collision), inputs.quantities);
  }
  return sensitivity_of_outcome(collision, colliding_truth(inputs.collision, model, branch).outcome, inputs.quantities);
}

namespace {

/// |μ N·F − ‖N × F‖|, F with κ = 1 + e_t, from below: near the surface it is what rounding would leave.
double distance_from_cone(const BasicCollision<Enclosure>& c) {
  const detail::RoughImpulses<Enclosure> of(c, nullptr);
  const Vector3<Enclosure> whole = Rough::combined<Enclosure>(c, of.stops_approach, of.difference(),
                                                              Enclosure(Enclosure(1.0) + c.tangential_restitution));
  const Vector3<Enclosure> tangential = c.normal.cross(whole);
  return Enclosure(c.friction * c.normal.dot(whole) - sqrt(Enclosure(tangential.dot(tangential)))).magnitude_below();
}

}  // namespace

ConeDistance cone_distance(const Collision& c) {
  const Places places(c);
  using T = Dual<double, 7>;
  const Differentiated approach = differentiated<Rough::StopsApproach>(c, places, T(0));
  const Differentiated point = differentiated<Rough::StopsPoint>(c, places, T(0));
  const Vector3<double> d = point.impulse - approach.impulse;
  const double share = 1 + c.tangential_restitution;
  const Vector3<double> whole = Rough::combined<double>(c, approach.impulse, d, share);
  const Jacobian& d_approach = approach.derivatives.of_impulse;
  Jacobian d_whole = (1 + c.restitution) * d_approach + share * (point.derivatives.of_impulse - d_approach);
  d_whole.col(places.restitution()) += approach.impulse;
  d_whole.col(places.tangential_restitution()) += d;
  const Vector3<double>& n = c.normal;
  Row d_limit = c.friction * n.transpose() * d_whole;
  d_limit.segment<3>(places.normal) += c.friction * whole.transpose();
  d_limit[places.friction()] += n.dot(whole);
  Jacobian d_tangential = Jacobian::Zero();
  for (Eigen::Index j = 0; j < d_whole.cols(); ++j) {
    d_tangential.col(j) = n.cross(d_whole.col(j));
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    d_tangential.col(places.normal + i) += Vector3<double>::Unit(i).cross(whole);
  }
  Jacobian d_limit_alone = Jacobian::Zero();
  d_limit_alone.row(0) = d_limit;
  return {distance_from_cone(map_numbers<Enclosure>(c, [](double x) { return Enclosure(x); })),
          weighted_norm(d_limit_alone, places.quantities) + weighted_norm(d_tangential, places.quantities)};
}

ConeDistance enclosed_cone_distance(const Collision& collision) {
  using T = Dual<Enclosure, collision_inputs>;
  const auto inputs = dual_inputs<Enclosure, collision_inputs>(collision, [](double x) { return Enclosure(x); });
  const BasicCollision<T>& c = inputs.collision;
  const detail::RoughImpulses<T> of(c, nullptr);
  const Vector3<T> whole =
      Rough::combined<T>(c, of.stops_approach, of.difference(), T(T(1) + c.tangential_restitution));
  const T limit = c.friction * c.normal.dot(whole);
  const Vector3<T> tangential = c.normal.cross(whole);
  const auto enclosed = map_numbers<Enclosure>(collision, [](double x) { return Enclosure(x); });
  return {distance_from_cone(enclosed),
          sensitivity_of({&limit}, inputs.quantities) +
              sensitivity_of({&tangential[0], &tangential[1], &tangential[2]}, inputs.quantities)};
}

}  // namespace carom::oracles
