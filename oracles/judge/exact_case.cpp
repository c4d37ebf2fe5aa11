// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/oracles/filters/case_bounds.hpp>
#include <carom/oracles/filters/definiteness_bounds.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/laws/certify.hpp>
#include <carom/oracles/laws/rough.hpp>
#include <carom/oracles/models/models.hpp>

namespace carom::oracles {
namespace {

/// Whether bounds show that a vector is not zero.
bool is_surely_not_zero(const Vector3<Approximation>& v) {
  return v[0].sign().value_or(0) != 0 || v[1].sign().value_or(0) != 0 || v[2].sign().value_or(0) != 0;
}

bool is_zero(const Vector3<Rational>& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

/// r × N.
template <class T>
Vector3<T> torque_arm(const BasicBody<T>& body, const BasicCollision<T>& c) {
  return lever_arm(body, c.point).cross(c.normal);
}

/// τ_k of `sensitivity`; zero where it is beyond the range of numbers.
Sensitivity second_order_scale(const Collision& c) {
  // A lever arm is perturbed by the places that it is the difference of.
  const auto reach = [&](const Body& body) { return norm_of(c.point) + length_of_position(body); };
  double speed = 0;
  double lambda = 0;
  for (const Body* body : {&c.a, &c.b}) {
    speed += norm_of(body->velocity) + norm_of(body->angular_velocity) * reach(*body);
    lambda += body->immovable ? 0 : 1 / body->mass;
  }
  const double impulse = lambda > 0 ? 2 * speed / lambda : 0;
  const auto of_velocity = [&](const Body& body) {
    return norm_of(body.velocity) + (body.immovable ? 0 : impulse / body.mass);
  };
  const auto of_spin = [&](const Body& body) {
    return norm_of(body.angular_velocity) +
           (body.immovable ? 0 : impulse * reach(body) / body.principal_inertia.minCoeff());
  };
  Sensitivity scale{};
  scale[OutcomeVector::velocity_of_a] = of_velocity(c.a);
  scale[OutcomeVector::angular_velocity_of_a] = of_spin(c.a);
  scale[OutcomeVector::velocity_of_b] = of_velocity(c.b);
  scale[OutcomeVector::angular_velocity_of_b] = of_spin(c.b);
  for (const OutcomeVector k : all_outcome_vectors) {
    scale[k] = std::isfinite(scale[k]) ? scale[k] : 0;
  }
  return scale;
}

/// Σ_q ‖∂(N·V⁻)/∂q‖ ‖q‖: the derivatives of N·(v + w × r) are V by N, N by v, r × N by w, and N × w by r = P − X.
double sensitivity_of_normal_velocity(const Collision& c) {
  // What is zero cannot be perturbed relatively, though its derivative be infinite.
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

}  // namespace

ExactCase::ExactCase(const Collision& collision, bool filtered) : bounds_(collision), filtered_(filtered) {}

const BasicCollision<Rational>& ExactCase::exact() const {
  if (!exact_) {
    exact_ = lift(collision());
  }
  return *exact_;
}

const BoundedCase::NormalVelocity& ExactCase::normal_velocity() const {
  if (!normal_velocity_ && filtered_) {
    normal_velocity_ = bounds_.normal_velocity();
  }
  if (!normal_velocity_) {
    const Rational exactly = normal_velocity_before(exact());
    normal_velocity_ = {to_double(exactly), sign_of(exactly)};
  }
  return *normal_velocity_;
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
  if (bounds_.is_moderate() && std::abs(normal_velocity().value) > case_bounds::factor_for_grazing * allowance *
                                                                       bounds_.normal_velocity_sensitivity_above()) {
    return false;
  }
  return std::abs(normal_velocity().value) <= allowance * normal_velocity_sensitivity();
}

double ExactCase::normal_velocity_sensitivity() const {
  if (!normal_velocity_sensitivity_) {
    normal_velocity_sensitivity_ = sensitivity_of_normal_velocity(collision());
  }
  return *normal_velocity_sensitivity_;
}

const PermittedInputs* ExactCase::permitted_inputs(double allowance) const {
  constexpr double most = 0.5;
  if (!(allowance > 0 && allowance < most)) {
    return nullptr;
  }
  const auto [known, is_new] = permitted_inputs_.try_emplace(allowance);
  if (is_new && PermittedInputs::first_order_is_blind(collision(), allowance, normal_velocity_sensitivity())) {
    known->second.emplace(bounds_, allowance);
  }
  return known->second ? &*known->second : nullptr;
}

Branch ExactCase::branch(Model model) const {
  CAROM_EXPECTS(has_movable_body(collision()));
  if (model != Model::rough || collision().friction == 0) {
    return Branch::only;
  }
  return is_inside_cone() ? Branch::inside_cone : Branch::on_cone;
}

bool ExactCase::is_inside_cone() const {
  if (!is_inside_cone_ && filtered_) {
    is_inside_cone_ = bounds_.is_inside_cone();
  }
  if (!is_inside_cone_) {
    is_inside_cone_ = oracles::is_inside_cone<Rational>(exact(), nullptr, &known_sign);
  }
  return *is_inside_cone_;
}

bool ExactCase::reaches_cone() const {
  if (!reaches_cone_ && filtered_) {
    reaches_cone_ = bounds_.reaches_cone();
  }
  if (!reaches_cone_) {
    reaches_cone_ = oracles::reaches_cone<Rational>(exact(), nullptr, &known_sign);
  }
  return *reaches_cone_;
}

namespace {

/// The truth of the law `rough` in the field T, certified.
template <class T>
Truth<T> certified_rough(const BasicCollision<T>& c, Branch branch) {
  Truth<T> truth = colliding_truth(c, Model::rough, branch);
  const detail::RoughImpulses<T> of(c, nullptr);
  const auto after = [&](const Vector3<T>& impulse) { return sum(unchanged(c), response<T>(c, impulse)); };
  certify_rough<T>(c, truth.outcome,
                   {after(of.stops_approach), after(of.stops_point),
                    Rough::friction_share<T>(c, of.stops_approach, of.difference(), branch)});
  certify(c, Model::rough, Approach::colliding, truth.outcome);
  return truth;
}

}  // namespace

const Truth<Rational>& ExactCase::truth(Model model, Approach as) const {
  CAROM_EXPECTS(as != Approach::colliding || branch(model) != Branch::on_cone, model);
  std::optional<Truth<Rational>>& known = as == Approach::colliding ? of_model_[model].truth : unchanged_;
  if (!known) {
    if (as == Approach::colliding && model == Model::rough) {
      known = certified_rough(exact(), branch(model));
    } else {
      Truth<Rational> truth = truth_of(exact(), model, as, Branch::only);
      certify(exact(), model, as, truth.outcome);
      known = std::move(truth);
    }
  }
  return *known;
}

const Truth<Radical>& ExactCase::truth_on_cone(Model model) const {
  std::optional<Truth<Radical>>& known = of_model_[model].truth_on_cone;
  if (!known) {
    known = certified_rough(map_numbers<Radical>(collision(), [](double number) { return Radical(number); }),
                            Branch::on_cone);
  }
  return *known;
}

Outcome<double> ExactCase::nearest_truth(Model model) const {
  return with_truth(model, approach(), []<class T>(const Truth<T>& truth) {
    return map_outcome<double>(truth.outcome, [](const T& x) { return nearest_double(x); });
  });
}

bool ExactCase::is_near_cone_surface(Model model, double allowance) const {
  if (branch(model) == Branch::only) {
    return false;
  }
  if (!cone_distance_) {
    cone_distance_ = bounds_.is_moderate() && bounds_.is_well_conditioned() ? cone_distance(collision())
                                                                            : enclosed_cone_distance(collision());
  }
  const PermittedInputs* permitted = permitted_inputs(allowance);
  return cone_distance_->is_within(allowance) || (permitted != nullptr && permitted->reach_both_sides_of_cone());
}

bool ExactCase::acts_at_once_here(Model model, double allowance) const {
  return acts_at_once(model, branch(model)) || is_near_cone_surface(model, allowance);
}

bool ExactCase::is_open(Model model, double allowance) const {
  return approach() != Approach::inert && branch(model) != Branch::only && is_grazing(allowance) &&
         is_near_cone_surface(model, allowance);
}

Approach ExactCase::answered_as(Model model, Approach as) const {
  const bool acts = as != Approach::colliding || approach() == Approach::colliding || branch(model) != Branch::on_cone;
  return acts ? as : approach();
}

const Truth<Enclosure>& ExactCase::enclosed_truth(Model model, Approach as) const {
  if (answered_as(model, as) == Approach::colliding) {
    return bounds_.colliding_truth(model, branch(model));
  }
  if (!enclosed_unchanged_) {
    enclosed_unchanged_ = truth_of(bounds_.enclosed(), model, as, Branch::only);
  }
  return *enclosed_unchanged_;
}

const Sensitivity& ExactCase::unchanged_sensitivity() const {
  if (!unchanged_sensitivity_) {
    unchanged_sensitivity_ = bounds_.norms_before();
    const Outcome<double> outcome = unchanged(collision());
    for (const OutcomeVector k : all_outcome_vectors) {
      // The derivative of a vector by itself is the identity, whose Frobenius norm is √3.
      (*unchanged_sensitivity_)[k] += std::sqrt(3.0) * norm_of(*vectors(outcome)[k]);
    }
  }
  return *unchanged_sensitivity_;
}

Sensitivity ExactCase::sensitivity(Model model, double allowance) const {
  const bool may_collide =
      approach() == Approach::colliding || (is_grazing(allowance) && !acts_at_once_here(model, allowance));
  return sensitivity_as(model, may_collide ? Approach::colliding : approach(), allowance);
}

Sensitivity ExactCase::sensitivity_as(Model model, Approach as, double allowance) const {
  const bool collides = as == Approach::colliding &&
                        (approach() == Approach::colliding || branch(model) != Branch::on_cone || reaches_cone());
  Sensitivity sum = collides ? colliding_first_order(model, branch(model)) : unchanged_sensitivity();
  if (collides && is_near_cone_surface(model, allowance) && reaches_cone()) {
    const Sensitivity& beyond = colliding_first_order(model, other_side(branch(model)));
    for (const OutcomeVector k : all_outcome_vectors) {
      sum[k] = std::max(sum[k], beyond[k]);
    }
  }
  for (const OutcomeVector k : all_outcome_vectors) {
    sum[k] += allowance * second_order()[k];
  }
  if (const PermittedInputs* permitted = collides ? permitted_inputs(allowance) : nullptr) {
    const Branch side = branch(model);
    const Vector3<double> impulse =
        bounds_.colliding_truth(model, side).impulse.unaryExpr([](const Enclosure& x) { return x.middle(); });
    const bool from_rest = approach() != Approach::colliding && !acts_at_once_here(model, allowance);
    const PerVector<double> distance = permitted->distance_of_answers(impulse, model, side, from_rest);
    for (const OutcomeVector k : all_outcome_vectors) {
      sum[k] = std::max(sum[k], distance[k] / allowance);
    }
  }
  return sum;
}

const Sensitivity& ExactCase::second_order() const {
  if (!second_order_) {
    second_order_ = second_order_scale(collision());
  }
  return *second_order_;
}

bool ExactCase::has_two_answers(Model model, double allowance) const {
  return is_grazing(allowance) && acts_at_once_here(model, allowance);
}

const Sensitivity& ExactCase::colliding_first_order(Model model, Branch branch) const {
  // In binary64 if that keeps ten digits, else in double-double arithmetic if that keeps three, else exactly.
  std::optional<Sensitivity>& known = of_model_[model].colliding_sensitivity[branch];
  if (!known && bounds_.is_moderate() && bounds_.is_well_conditioned() &&
      (branch != Branch::on_cone || bounds_.has_clear_divisor())) {
    known = colliding_sensitivity(collision(), model, branch);
  }
  if (!known) {
    known = enclosed_sensitivity(collision(), model, branch, bounds_.is_moderate());
  }
  if (!known) {
    known = exact_sensitivity(collision(), model, branch);
  }
  return *known;
}

bool ExactCase::is_moderate(Model model) const {
  return bounds_.is_moderate() &&
         (approach() == Approach::inert || branch(model) != Branch::on_cone || bounds_.has_clear_divisor());
}

const Sensitivity& ExactCase::sensitivity_below(Model model) const {
  CAROM_EXPECTS(is_moderate(model), model);
  return approach() == Approach::colliding ? bounds_.colliding_sensitivity_below(model, branch(model))
                                           : bounds_.norms_before();
}

const Matrix3<Rational>& ExactCase::collision_matrix() const {
  if (!collision_matrix_) {
    collision_matrix_ = response_matrix(exact());
  }
  return *collision_matrix_;
}

double ExactCase::collision_matrix_sensitivity(double allowance) const {
  if (!collision_matrix_sensitivity_) {
    const auto k = response_matrix(bounds_.differentiated().collision);
    collision_matrix_sensitivity_ =
        sensitivity_of({&k(0, 0), &k(0, 1), &k(0, 2), &k(1, 0), &k(1, 1), &k(1, 2), &k(2, 0), &k(2, 1), &k(2, 2)},
                       bounds_.differentiated().quantities);
  }
  const PermittedInputs* permitted = permitted_inputs(allowance);
  return *collision_matrix_sensitivity_ + (permitted != nullptr ? permitted->second_order_of_matrix() / allowance : 0);
}

bool ExactCase::is_definite() const {
  if (!is_definite_) {
    is_definite_ = filtered_ ? is_at_least_by_enclosures(collision_matrix(), inverse_mass(exact()))
                             : is_at_least(collision_matrix(), inverse_mass(exact()));
  }
  return *is_definite_;
}

bool ExactCase::is_bounded_by(const Rational& bound) const {
  if (!filtered_) {
    return is_at_most(collision_matrix(), bound);
  }
  const Matrix3<Enclosure> matrix = response_matrix(bounds_.enclosed());
  const std::optional<bool> decided =
      is_positive_semidefinite(less_multiple_of_identity<Enclosure>(-matrix, Enclosure(Rational(-bound))));
  return decided ? *decided : is_at_most_by_enclosures(collision_matrix(), bound);
}

bool ExactCase::is_collinear() const {
  if (!is_collinear_) {
    const auto is_along_normal = [&](BasicBody<Rational> BasicCollision<Rational>::*exact_body,
                                     BasicBody<Approximation> BasicCollision<Approximation>::*near_body) {
      const BasicCollision<Approximation>& near = bounds_.approximate();
      if ((near.*near_body).immovable) {
        return true;
      }
      return !(filtered_ && is_surely_not_zero(torque_arm(near.*near_body, near))) &&
             is_zero(torque_arm(exact().*exact_body, exact()));
    };
    is_collinear_ = is_along_normal(&BasicCollision<Rational>::a, &BasicCollision<Approximation>::a) &&
                    is_along_normal(&BasicCollision<Rational>::b, &BasicCollision<Approximation>::b);
  }
  return *is_collinear_;
}

bool ExactCase::is_head_on() const {
  if (!is_head_on_) {
    const auto tangential = [](const auto& c) {
      using T = std::decay_t<decltype(c.restitution)>;
      return Vector3<T>(c.normal.cross(relative_velocity<T>(c, unchanged(c))));
    };
    is_head_on_ = !(filtered_ && is_surely_not_zero(tangential(bounds_.approximate()))) && is_zero(tangential(exact()));
  }
  return *is_head_on_;
}

}  // namespace carom::oracles
