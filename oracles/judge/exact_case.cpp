// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/oracles/filters/definiteness_bounds.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/judge/permitted_noise.hpp>
#include <carom/oracles/laws/certify.hpp>
#include <carom/oracles/laws/rough.hpp>
#include <carom/oracles/models/models.hpp>

namespace carom::oracles {
namespace {

bool is_surely_not_zero(const Vector3<Enclosure>& v) {
  return std::any_of(v.begin(), v.end(), [](const Enclosure& x) { return x.sign().value_or(0) != 0; });
}

bool is_zero(const Vector3<Rational>& v) {
  return std::all_of(v.begin(), v.end(), [](const Rational& x) { return x == 0; });
}

/// r × N.
template <class T>
Vector3<T> torque_arm(const BasicBody<T>& body, const BasicCollision<T>& c) {
  return lever_arm(body, c.point).cross(c.normal);
}

/// Beyond the range of numbers, a part of second order is left out.
void drop_infinite(Sensitivity& scale) {
  for (const OutcomeVector k : all_outcome_vectors) {
    scale[k] = std::isfinite(scale[k]) ? scale[k] : 0;
  }
}

/// ‖J⁻¹ (I − f fᵀ)‖_F for the unit vector f: the largest spin that a torque of length 1 across f may cause.
double response_across(const Body& body, const Vector3<double>& f) {
  const Vector3<double> in_body = turned<double>(conjugate(body.orientation), f);
  return root_of_squares(3, [&](std::size_t i) {
    const double y = in_body[static_cast<Eigen::Index>((i + 1) % 3)];
    const double z = in_body[static_cast<Eigen::Index>((i + 2) % 3)];
    return std::sqrt(y * y + z * z) / body.principal_inertia[static_cast<Eigen::Index>(i)];
  });
}

/// Adds the changes of the velocities if K changes by at most `change_of(body)` ‖J⁻¹ (I − f fᵀ)‖ for each movable body,
/// with f along the impulse F. F then changes by at most the sum of these changes times ‖F‖ / λ, because K ⪰ λI.
template <class ChangeOf>
void add_change_of_matrix(const Collision& c, const Vector3<double>& impulse, const ChangeOf& change_of,
                          Sensitivity& scale) {
  const double length = norm_of(impulse);
  if (length == 0) {
    return;
  }
  double sum = 0;
  for (const Body* body : {&c.a, &c.b}) {
    sum += body->immovable ? 0 : change_of(*body) * response_across(*body, impulse / length);
  }
  const double change = sum / inverse_mass(c) * length;
  const auto add_body = [&](const Body& body, OutcomeVector velocity, OutcomeVector spin) {
    if (!body.immovable) {
      scale[velocity] += change / body.mass;
      scale[spin] += change * norm_of(lever_arm(body, c.point)) / body.principal_inertia.minCoeff();
    }
  };
  add_body(c.a, OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a);
  add_body(c.b, OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b);
}

/// [δr]ᵀ J⁻¹ [δr], the change of K of second order, changes F. The first order vanishes if r × N = 0.
void add_second_order_of_arms(const Collision& c, const Vector3<double>& impulse, Sensitivity& scale) {
  const auto squared = [&](const Body& body) {
    return length_of_lever_arm(body, c.point) * length_of_lever_arm(body, c.point);
  };
  add_change_of_matrix(c, impulse, squared, scale);
}

/// τ_k of ExactCase::sensitivity without the part by K, or zero if τ_k is beyond the range of numbers.
Sensitivity second_order_scale(const Collision& c) {
  double speed = 0;
  double lambda = 0;
  for (const Body* body : {&c.a, &c.b}) {
    speed += norm_of(body->velocity) + norm_of(body->angular_velocity) * length_of_lever_arm(*body, c.point);
    lambda += body->immovable ? 0 : 1 / body->mass;
  }
  const double impulse = 2 * speed / lambda;  // not used if both bodies are immovable
  const auto of_velocity = [&](const Body& body) {
    return norm_of(body.velocity) + (body.immovable ? 0 : impulse / body.mass);
  };
  const auto of_spin = [&](const Body& body) {
    return norm_of(body.angular_velocity) +
           (body.immovable ? 0 : impulse * length_of_lever_arm(body, c.point) / body.principal_inertia.minCoeff());
  };
  Sensitivity scale{};
  scale[OutcomeVector::velocity_of_a] = of_velocity(c.a);
  scale[OutcomeVector::angular_velocity_of_a] = of_spin(c.a);
  scale[OutcomeVector::velocity_of_b] = of_velocity(c.b);
  scale[OutcomeVector::angular_velocity_of_b] = of_spin(c.b);
  drop_infinite(scale);
  return scale;
}

/// Σ_q ‖∂(N·V⁻)/∂q‖ ‖q‖, from the derivatives of N·(v + w × r) with r = P − X.
double sensitivity_of_normal_velocity(const Collision& c) {
  // A quantity that is zero contributes nothing, even if its derivative is infinite.
  const auto weighted = [](const Vector3<double>& derivative, double length) {
    return length == 0 ? 0 : norm_of(derivative) * length;
  };
  double sum = weighted(relative_velocity<double>(c, unchanged(c)), norm_of(c.normal));
  for (const Body* body : {&c.a, &c.b}) {
    sum += weighted(c.normal, norm_of(body->velocity));
    sum += weighted(torque_arm(*body, c), norm_of(body->angular_velocity));
    sum += weighted(c.normal.cross(body->angular_velocity), length_of_position(*body));
  }
  return sum + weighted(c.normal.cross(c.a.angular_velocity - c.b.angular_velocity), norm_of(c.point));
}

std::optional<int> known_sign(const Rational& x) { return sign_of(x); }

/// Whether no divisor of the law's formula on this branch may be zero.
bool has_clear_divisor(const BoundedCase& bounds, Branch branch) {
  return branch != Branch::on_cone || bounds.has_clear_divisor();
}

}  // namespace

ExactCase::ExactCase(const Collision& collision, bool filtered) : filtered_(filtered), bounds_(collision) {}

const BasicCollision<Rational>& ExactCase::exact() const {
  return exact_.get([this] { return lift(collision()); });
}

const BoundedCase::NormalVelocity& ExactCase::normal_velocity() const {
  return normal_velocity_.get([this] {
    const std::optional<BoundedCase::NormalVelocity> bounded = filtered_ ? bounds_.normal_velocity() : std::nullopt;
    if (bounded) {
      return *bounded;
    }
    const Rational exactly = normal_velocity_before(exact());
    return BoundedCase::NormalVelocity{to_double(exactly), sign_of(exactly)};
  });
}

Approach ExactCase::approach() const {
  return collision().a.immovable && collision().b.immovable ? Approach::inert
                                                            : approach_of_sign(normal_velocity().sign);
}

bool ExactCase::is_grazing(double allowance) const {
  if (approach() == Approach::inert) {
    return false;
  }
  const PermittedInputs* permitted = permitted_inputs(allowance);
  if (permitted != nullptr && permitted->normal_velocity().contains(0)) {
    return true;
  }
  return std::abs(normal_velocity().value) <= allowance * normal_velocity_sensitivity();
}

double ExactCase::normal_velocity_sensitivity() const {
  return normal_velocity_sensitivity_.get([this] { return sensitivity_of_normal_velocity(collision()); });
}

const PermittedInputs* ExactCase::permitted_inputs(double allowance) const {
  constexpr double most = 0.5;
  if (!(allowance > 0 && allowance < most)) {
    return nullptr;
  }
  return permitted_inputs_
      .get(allowance,
           [&] {
             return PermittedInputs::first_order_is_blind(collision(), allowance, normal_velocity_sensitivity())
                        ? std::make_unique<PermittedInputs>(bounds_, allowance)
                        : nullptr;
           })
      .get();
}

Branch ExactCase::branch(Law law) const {
  CAROM_EXPECTS(has_movable_body(collision()));
  if (law != Law::rough || collision().friction == 0) {
    return Branch::only;
  }
  return is_inside_cone() ? Branch::inside_cone : Branch::on_cone;
}

bool ExactCase::is_inside_cone() const {
  return is_inside_cone_.get([this] {
    const std::optional<bool> bounded = filtered_ ? bounds_.is_inside_cone() : std::nullopt;
    return bounded ? *bounded : *oracles::is_inside_cone<Rational>(exact(), nullptr, &known_sign);
  });
}

bool ExactCase::reaches_cone() const {
  return reaches_cone_.get([this] {
    const std::optional<bool> bounded = filtered_ ? bounds_.reaches_cone() : std::nullopt;
    return bounded ? *bounded : *oracles::reaches_cone<Rational>(exact(), nullptr, &known_sign);
  });
}

namespace {

template <class T>
Truth<T> certified_rough(const BasicCollision<T>& c, Branch branch) {
  Truth<T> truth = colliding_truth(c, Law::rough, branch);
  const detail::RoughImpulses<T> of(c, nullptr);
  const auto after = [&](const Vector3<T>& impulse) { return sum(unchanged(c), response<T>(c, impulse)); };
  certify_rough<T>(c, truth.outcome,
                   {after(of.stops_approach), after(of.stops_point),
                    Rough::friction_share<T>(c, of.stops_approach, of.difference(), branch)});
  certify(c, Law::rough, Approach::colliding, truth.outcome);
  return truth;
}

}  // namespace

const Truth<Rational>& ExactCase::truth(Law law, Approach as) const {
  CAROM_EXPECTS(as != Approach::colliding || branch(law) != Branch::on_cone, law);
  return (as == Approach::colliding ? of(law).truth : unchanged_).get([&] {
    if (as == Approach::colliding && law == Law::rough) {
      return certified_rough(exact(), branch(law));
    }
    Truth<Rational> truth = truth_of(exact(), law, as, Branch::only);
    certify(exact(), law, as, truth.outcome);
    return truth;
  });
}

const Truth<Radical>& ExactCase::truth_on_cone(Law law) const {
  return of(law).truth_on_cone.get([this] {
    return certified_rough(map_numbers<Radical>(collision(), [](double number) { return Radical(number); }),
                           Branch::on_cone);
  });
}

Outcome<double> ExactCase::nearest_truth(Law law) const {
  return with_truth(law, approach(), []<class T>(const Truth<T>& truth) {
    return map_outcome<double>(truth.outcome, [](const T& x) { return nearest_double(x); });
  });
}

bool ExactCase::is_near_cone_surface(Law law, double allowance) const {
  if (branch(law) == Branch::only) {
    return false;
  }
  const ConeDistance& distance = cone_distance_.get([this] {
    return bounds_.is_moderate() && bounds_.is_well_conditioned() ? cone_distance(collision())
                                                                  : enclosed_cone_distance(collision());
  });
  const PermittedInputs* permitted = permitted_inputs(allowance);
  return distance.is_within(allowance) || (permitted != nullptr && permitted->reach_both_sides_of_cone(bounds_));
}

bool ExactCase::acts_at_once_here(Law law, double allowance) const {
  return acts_at_once(law, branch(law)) || is_near_cone_surface(law, allowance);
}

bool ExactCase::is_open(Law law, double allowance) const {
  return approach() != Approach::inert && branch(law) != Branch::only && is_grazing(allowance) &&
         is_near_cone_surface(law, allowance);
}

Approach ExactCase::answered_as(Law law, Approach as) const {
  const bool acts = as != Approach::colliding || approach() == Approach::colliding || branch(law) != Branch::on_cone;
  return acts ? as : approach();
}

const Truth<Enclosure>& ExactCase::enclosed_truth(Law law, Approach as) const {
  if (answered_as(law, as) == Approach::colliding) {
    return bounds_.colliding_truth(law, branch(law));
  }
  return enclosed_unchanged_.get([&] { return truth_of(bounds_.enclosed(), law, as, Branch::only); });
}

void ExactCase::check_enclosed_truth(Law law, Approach as) const {
  if (law == Law::rough) {
    with_truth(law, as, [](const auto&) {});
    return;
  }
  is_enclosed_truth_checked_.get({law, as}, [&] {
    const Truth<Enclosure>& truth = enclosed_truth(law, as);
    if (const char* const name = first_refuted(collision(), bounds_.enclosed(), law, as, truth.outcome)) {
      throw JudgeError(std::string("the enclosed truth does not satisfy ") + name, collision());
    }
    return true;
  });
}

const Sensitivity& ExactCase::unchanged_sensitivity() const {
  return unchanged_sensitivity_.get([this] {
    Sensitivity sum = bounds_.norms_before();
    const Outcome<double> outcome = unchanged(collision());
    for (const OutcomeVector k : all_outcome_vectors) {
      // The derivative of a vector with respect to itself is the identity, whose Frobenius norm is √3.
      sum[k] += std::sqrt(3.0) * norm_of(*vectors(outcome)[k]);
    }
    return sum;
  });
}

Sensitivity ExactCase::sensitivity(Law law, double allowance) const {
  const bool may_collide =
      approach() == Approach::colliding || (is_grazing(allowance) && !acts_at_once_here(law, allowance));
  return sensitivity_as(law, may_collide ? Approach::colliding : approach(), allowance);
}

Sensitivity ExactCase::sensitivity_with_noise(Law law, const Yardstick& yardstick) const {
  Sensitivity sum = sensitivity(law, yardstick.allowance());
  add_permitted_noise(collision(), yardstick, sum);
  return sum;
}

Sensitivity ExactCase::sensitivity_as(Law law, Approach as, double allowance) const {
  const bool collides = as == Approach::colliding &&
                        (approach() == Approach::colliding || branch(law) != Branch::on_cone || reaches_cone());
  Sensitivity sum = collides ? colliding_first_order(law, branch(law)) : unchanged_sensitivity();
  if (collides && is_near_cone_surface(law, allowance) && reaches_cone()) {
    const Sensitivity& beyond = colliding_first_order(law, other_side(branch(law)));
    for (const OutcomeVector k : all_outcome_vectors) {
      sum[k] = std::max(sum[k], beyond[k]);
    }
  }
  const bool grazes = collides && is_grazing(allowance);
  for (const OutcomeVector k : all_outcome_vectors) {
    sum[k] += allowance * second_order()[k];
    if (collides) {
      sum[k] += allowance * (second_order_of_arms(law)[k] + (grazes ? second_order_from_rest()[k] : 0));
    }
  }
  if (const PermittedInputs* permitted = collides ? permitted_inputs(allowance) : nullptr) {
    const Branch side = branch(law);
    const Vector3<double> impulse =
        bounds_.colliding_truth(law, side).impulse.unaryExpr([](const Enclosure& x) { return x.middle(); });
    const bool from_rest = approach() != Approach::colliding && !acts_at_once_here(law, allowance);
    const PerVector<double> distance = permitted->distance_of_answers(bounds_, impulse, law, side, from_rest);
    for (const OutcomeVector k : all_outcome_vectors) {
      sum[k] = std::max(sum[k], distance[k] / allowance);
    }
  }
  return sum;
}

const Sensitivity& ExactCase::second_order() const {
  return second_order_.get([this] { return second_order_scale(collision()); });
}

const Sensitivity& ExactCase::second_order_of_arms(Law law) const {
  return of(law).second_order_of_arms.get([&] {
    const Collision& c = collision();
    Sensitivity scale{};
    if (branch(law) != Branch::only) {
      // F = (1 + ε) P_I + κ (P_II − P_I) with κ ≤ 1 + e_t.
      const double share = 1 + c.tangential_restitution;
      add_second_order_of_arms(c, (1 + c.restitution + share) * bounds_.stop_impulses().of_approach, scale);
      add_second_order_of_arms(c, share * bounds_.stop_impulses().of_point, scale);
    } else {
      add_second_order_of_arms(
          c, bounds_.colliding_truth(law, branch(law)).impulse.unaryExpr([](const Enclosure& x) { return x.middle(); }),
          scale);
    }
    drop_infinite(scale);
    return scale;
  });
}

const Sensitivity& ExactCase::second_order_from_rest() const {
  return second_order_from_rest_.get([this] {
    const Collision& c = collision();
    const double normal = norm_of(c.normal);
    // |N·V⁻| and its rounding are at most the allowance times the sensitivity each, and λ ‖F‖ ≤ (1 + ε) |N·V⁻| / ‖N‖.
    const double impulse =
        (1 + c.restitution) * 2 * normal_velocity_sensitivity() / (normal * oracles::inverse_mass(c));
    const auto crossed = [&](const Body& body) {
      return 2 * length_of_lever_arm(body, c.point) * norm_of(lever_arm(body, c.point));
    };
    Sensitivity scale{};
    add_change_of_matrix(c, c.normal * (impulse / normal), crossed, scale);
    drop_infinite(scale);
    return scale;
  });
}

bool ExactCase::has_two_answers(Law law, double allowance) const {
  // Without a cone, the law alone decides whether it acts at once.
  const bool has_cone = law == Law::rough && collision().friction != 0;
  if (!has_cone && !acts_at_once(law, Branch::only)) {
    return false;
  }
  return is_grazing(allowance) && acts_at_once_here(law, allowance);
}

const Sensitivity& ExactCase::colliding_first_order(Law law, Branch branch) const {
  // Binary64 or double-double arithmetic if it does not lose too many digits, otherwise exact arithmetic.
  return of(law).colliding_sensitivity[branch].get([&]() -> Sensitivity {
    if (bounds_.is_moderate() && bounds_.is_well_conditioned() && has_clear_divisor(bounds_, branch)) {
      if (const auto known = colliding_sensitivity(collision(), law, branch)) {
        return *known;
      }
    }
    if (const auto known = enclosed_sensitivity(collision(), law, branch, bounds_.is_moderate())) {
      return *known;
    }
    return exact_sensitivity(collision(), law, branch);
  });
}

bool ExactCase::is_moderate(Law law) const {
  return bounds_.is_moderate() && (approach() == Approach::inert || has_clear_divisor(bounds_, branch(law)));
}

const Sensitivity& ExactCase::sensitivity_below(Law law) const {
  CAROM_EXPECTS(is_moderate(law), law);
  return approach() == Approach::colliding ? bounds_.colliding_sensitivity_below(law, branch(law))
                                           : bounds_.norms_before();
}

const Matrix3<Rational>& ExactCase::collision_matrix() const {
  return collision_matrix_.get([this] { return response_matrix(exact()); });
}

double ExactCase::collision_matrix_sensitivity(double allowance) const {
  const double first_order = collision_matrix_sensitivity_.get([this] {
    const auto k = response_matrix(bounds_.differentiated().collision);
    return sensitivity_of({&k(0, 0), &k(0, 1), &k(0, 2), &k(1, 0), &k(1, 1), &k(1, 2), &k(2, 0), &k(2, 1), &k(2, 2)},
                          bounds_.differentiated().quantities);
  });
  const PermittedInputs* permitted = permitted_inputs(allowance);
  return first_order + (permitted != nullptr ? permitted->second_order_of_matrix() / allowance : 0);
}

bool ExactCase::is_definite() const {
  return is_definite_.get([this] {
    return filtered_ ? is_at_least_by_enclosures(collision_matrix(), inverse_mass(exact()))
                     : is_at_least(collision_matrix(), inverse_mass(exact()));
  });
}

bool ExactCase::is_bounded_by(const Rational& bound) const {
  if (!filtered_) {
    return is_at_most(collision_matrix(), bound);
  }
  const std::optional<bool> decided = is_positive_semidefinite(
      less_multiple_of_identity<Enclosure>(-bounds_.collision_matrix(), Enclosure(Rational(-bound))));
  return decided ? *decided : is_at_most_by_enclosures(collision_matrix(), bound);
}

bool ExactCase::is_collinear() const {
  return is_collinear_.get([this] {
    const auto is_along_normal = [&](BasicBody<Rational> BasicCollision<Rational>::*exact_body,
                                     BasicBody<Enclosure> BasicCollision<Enclosure>::*near_body) {
      const BasicCollision<Enclosure>& near = bounds_.enclosed();
      if ((near.*near_body).immovable) {
        return true;
      }
      return !(filtered_ && is_surely_not_zero(torque_arm(near.*near_body, near))) &&
             is_zero(torque_arm(exact().*exact_body, exact()));
    };
    return is_along_normal(&BasicCollision<Rational>::a, &BasicCollision<Enclosure>::a) &&
           is_along_normal(&BasicCollision<Rational>::b, &BasicCollision<Enclosure>::b);
  });
}

bool ExactCase::is_head_on() const {
  return is_head_on_.get([this] {
    const auto tangential = [](const auto& c) {
      using T = std::decay_t<decltype(c.restitution)>;
      return Vector3<T>(c.normal.cross(relative_velocity<T>(c, unchanged(c))));
    };
    return !(filtered_ && is_surely_not_zero(tangential(bounds_.enclosed()))) && is_zero(tangential(exact()));
  });
}

}  // namespace carom::oracles
