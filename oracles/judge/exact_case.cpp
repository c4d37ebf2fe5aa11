// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/bounds/lifted_outcome.hpp>
#include <carom/oracles/bounds/moderate.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/laws/certify.hpp>
#include <carom/oracles/laws/rough.hpp>
#include <carom/oracles/truths/models.hpp>

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

/// of(k) for each vector k of an outcome.
template <class Of>
Sensitivity per_vector(const Of& of) {
  Sensitivity all;
  for (const OutcomeVector k : all_outcome_vectors) {
    all[k] = of(k);
  }
  return all;
}

std::optional<int> known_sign(const Enclosure& x) { return x.sign(); }
std::optional<int> known_sign(const Rational& x) { return sign_of(x); }

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
  return x.is_exactly_zero() || x.radius() < exact_case_bounds::known_radius_of_normal_velocity * x.magnitude_below();
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

ExactCase::ExactCase(const Collision& collision, bool filtered) : collision_(collision), filtered_(filtered) {
  CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
}

const BasicCollision<Rational>& ExactCase::exact() const {
  return exact_.get([this] { return lift(collision()); });
}

const BasicCollision<Enclosure>& ExactCase::enclosed() const {
  return enclosed_.get(
      [this] { return map_numbers<Enclosure>(collision_, [](double number) { return Enclosure(number); }); });
}

const DualInputs<double, collision_inputs>& ExactCase::differentiated() const {
  return *differentiated_.get([this] {
    return std::make_unique<DualInputs<double, collision_inputs>>(
        dual_inputs<double, collision_inputs>(collision_, [](double x) { return x; }));
  });
}

bool ExactCase::is_moderate() const {
  return is_moderate_.get([this] { return oracles::is_moderate(collision_); });
}

const ExactCase::NormalVelocity& ExactCase::normal_velocity() const {
  return normal_velocity_.get([this] {
    if (filtered_) {
      if (const Enclosure closely = normal_velocity_before(enclosed()); is_known_to_six_digits(closely)) {
        return NormalVelocity{closely.middle(), *closely.sign()};
      }
    }
    const Rational exactly = normal_velocity_before(exact());
    return NormalVelocity{to_double(exactly), sign_of(exactly)};
  });
}

const Vector3<double>& ExactCase::relative_velocity() const {
  return relative_velocity_.get(
      [this] { return middle(oracles::relative_velocity<Enclosure>(enclosed(), unchanged(enclosed()))); });
}

const Sensitivity& ExactCase::norms_before() const {
  return norms_before_.get([this] { return oracles::norms_before(collision_); });
}

const ExactCase::StopImpulses& ExactCase::stop_impulses() const {
  return stop_impulses_.get([this] {
    const detail::RoughImpulses<Enclosure> of(enclosed(), &enclosed_collision_matrix());
    return StopImpulses{middle(of.stops_approach), middle(of.stops_point)};
  });
}

ContactState ExactCase::state() const {
  return collision().a.immovable && collision().b.immovable ? ContactState::inert
                                                            : state_of_sign(normal_velocity().sign);
}

bool ExactCase::is_grazing(double allowance) const {
  if (state() == ContactState::inert) {
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
             return PermittedInputs::derivatives_fail(collision(), allowance, normal_velocity_sensitivity())
                        ? std::make_unique<PermittedInputs>(*this, allowance)
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
    const auto sign = [](const auto& x) { return known_sign(x); };
    const std::optional<bool> bounded =
        filtered_ ? oracles::is_inside_cone(enclosed(), &enclosed_collision_matrix(), sign) : std::nullopt;
    return bounded ? *bounded : *oracles::is_inside_cone<Rational>(exact(), nullptr, sign);
  });
}

bool ExactCase::reaches_cone() const {
  return reaches_cone_.get([this] {
    const auto sign = [](const auto& x) { return known_sign(x); };
    const std::optional<bool> bounded =
        filtered_ ? oracles::reaches_cone(enclosed(), &enclosed_collision_matrix(), sign) : std::nullopt;
    return bounded ? *bounded : *oracles::reaches_cone<Rational>(exact(), nullptr, sign);
  });
}

bool ExactCase::has_clear_divisor() const {
  CAROM_EXPECTS(is_moderate());
  return has_clear_divisor_.get([this] {
    const BasicCollision<Enclosure>& c = enclosed();
    const Vector3<Enclosure> d = detail::RoughImpulses<Enclosure>(c, &enclosed_collision_matrix()).difference();
    const Vector3<Enclosure> tangential = c.normal.cross(d);
    const double terms = sqrt(Enclosure(tangential.dot(tangential))).magnitude_above() +
                         (c.friction * c.normal.dot(d)).magnitude_above();
    return Rough::divisor<Enclosure>(c, d).magnitude_below() >= exact_case_bounds::least_share_of_divisor * terms;
  });
}

namespace {

/// The parts of the truth of `rough`. `matrix` is K, or nullptr.
template <class T>
RoughParts<T> parts_of_rough(const BasicCollision<T>& c, const Matrix3<T>* matrix, Branch branch) {
  const detail::RoughImpulses<T> of(c, matrix);
  const auto after = [&](const Vector3<T>& impulse) { return sum(unchanged(c), response<T>(c, impulse)); };
  return {after(of.stops_approach), after(of.stops_point),
          Rough::friction_share<T>(c, of.stops_approach, of.difference(), branch)};
}

template <class T>
Truth<T> certified_rough(const BasicCollision<T>& c, Branch branch) {
  Truth<T> truth = colliding_truth(c, Law::rough, branch);
  certify_rough<T>(c, truth.outcome, parts_of_rough<T>(c, nullptr, branch));
  certify(c, Law::rough, ContactState::colliding, truth.outcome);
  return truth;
}

}  // namespace

const Truth<Rational>& ExactCase::truth(Law law, ContactState as) const {
  CAROM_EXPECTS(as != ContactState::colliding || branch(law) != Branch::on_cone, law);
  return (as == ContactState::colliding ? of(law).truth : unchanged_).get([&] {
    if (as == ContactState::colliding && law == Law::rough) {
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
  return with_truth(law, state(), []<class T>(const Truth<T>& truth) {
    return map_outcome<double>(truth.outcome, [](const T& x) { return nearest_double(x); });
  });
}

bool ExactCase::is_near_cone_surface(Law law, double allowance) const {
  if (branch(law) == Branch::only) {
    return false;
  }
  const ConeDistance& distance = cone_distance_.get([this] {
    return is_moderate() && is_well_conditioned() ? cone_distance(collision()) : enclosed_cone_distance(collision());
  });
  const PermittedInputs* permitted = permitted_inputs(allowance);
  return distance.is_within(allowance) || (permitted != nullptr && permitted->reach_both_sides_of_cone(*this));
}

bool ExactCase::acts_at_once_here(Law law, double allowance) const {
  return acts_at_once(law, branch(law)) || is_near_cone_surface(law, allowance);
}

bool ExactCase::is_open(Law law, double allowance) const {
  return state() != ContactState::inert && branch(law) != Branch::only && is_grazing(allowance) &&
         is_near_cone_surface(law, allowance);
}

ContactState ExactCase::answered_as(Law law, ContactState as) const {
  const bool acts =
      as != ContactState::colliding || state() == ContactState::colliding || branch(law) != Branch::on_cone;
  return acts ? as : state();
}

const Truth<Enclosure>& ExactCase::colliding_truth(Law law) const {
  return of(law).enclosed_truth.get([&] {
    const Branch side = branch(law);
    // An impulse along N needs K N alone. The sum over columns of K would cancel if a lever arm is along N.
    const bool is_along_normal =
        with_law(law, side, []<class LawType>(LawType) { return std::is_same_v<LawType, Frictionless>; });
    return oracles::colliding_truth(enclosed(), law, side, is_along_normal ? nullptr : &enclosed_collision_matrix());
  });
}

Vector3<double> ExactCase::colliding_impulse(Law law) const { return middle(colliding_truth(law).impulse); }

const Truth<Enclosure>& ExactCase::enclosed_truth(Law law, ContactState as) const {
  const ContactState answered = answered_as(law, as);
  return answered == ContactState::colliding
             ? colliding_truth(law)
             : enclosed_unchanged_.get([&] { return truth_of(enclosed(), law, answered, Branch::only); });
}

void ExactCase::check_enclosed_truth(Law law, ContactState as) const {
  is_enclosed_truth_checked_.get({law, as}, [&] {
    const ContactState answered = answered_as(law, as);
    const Outcome<Enclosure>& outcome = enclosed_truth(law, as).outcome;
    throw_if_refuted(first_refuted(collision(), enclosed(), law, answered, outcome), "the enclosed truth", collision());
    if (law == Law::rough && answered == ContactState::colliding) {
      const auto parts = parts_of_rough(enclosed(), &enclosed_collision_matrix(), branch(law));
      throw_if_refuted(first_refuted_of_rough(collision(), enclosed(), outcome, parts), "the enclosed truth of `rough`",
                       collision());
    }
    return true;
  });
}

const Sensitivity& ExactCase::unchanged_sensitivity() const {
  return unchanged_sensitivity_.get([this] {
    const Outcome<double> outcome = unchanged(collision());
    // The derivative of a vector with respect to itself is the identity, whose Frobenius norm is √3.
    return per_vector(
        [&](OutcomeVector k) { return norms_before()[k] + std::sqrt(3.0) * norm_of(*vectors(outcome)[k]); });
  });
}

Sensitivity ExactCase::sensitivity(Law law, double allowance) const {
  const bool may_collide =
      state() == ContactState::colliding || (is_grazing(allowance) && !acts_at_once_here(law, allowance));
  return sensitivity_as(law, may_collide ? ContactState::colliding : state(), allowance);
}

Sensitivity ExactCase::sensitivity_with_noise(Law law, const Yardstick& yardstick) const {
  Sensitivity sum = sensitivity(law, yardstick.allowance());
  add_permitted_noise(collision(), yardstick, sum);
  return sum;
}

Sensitivity ExactCase::sensitivity_as(Law law, ContactState as, double allowance) const {
  const bool collides = as == ContactState::colliding &&
                        (state() == ContactState::colliding || branch(law) != Branch::on_cone || reaches_cone());
  return collides
             ? colliding_sensitivity(law, allowance)
             : per_vector([&](OutcomeVector k) { return unchanged_sensitivity()[k] + allowance * second_order()[k]; });
}

Sensitivity ExactCase::colliding_sensitivity(Law law, double allowance) const {
  Sensitivity sum = colliding_first_order(law, branch(law));
  const auto at_least = [&](const auto& other) {
    sum = per_vector([&](OutcomeVector k) { return std::max(sum[k], other(k)); });
  };
  if (is_near_cone_surface(law, allowance) && reaches_cone()) {
    const Sensitivity& beyond = colliding_first_order(law, other_side(branch(law)));
    at_least([&](OutcomeVector k) { return beyond[k]; });
  }
  const bool grazes = is_grazing(allowance);
  sum = per_vector([&](OutcomeVector k) {
    return sum[k] + allowance * second_order()[k] +
           allowance * (second_order_of_arms(law)[k] + (grazes ? second_order_from_rest()[k] : 0));
  });
  if (const PermittedInputs* permitted = permitted_inputs(allowance)) {
    const bool from_rest = state() != ContactState::colliding && !acts_at_once_here(law, allowance);
    const PerVector<double> distance =
        permitted->distance_of_answers(*this, colliding_impulse(law), law, branch(law), from_rest);
    at_least([&](OutcomeVector k) { return distance[k] / allowance; });
  }
  return sum;
}

const Sensitivity& ExactCase::second_order() const {
  return second_order_.get([this] { return oracles::second_order(collision()); });
}

const Sensitivity& ExactCase::second_order_of_arms(Law law) const {
  return of(law).second_order_of_arms.get([&]() -> Sensitivity {
    const Collision& c = collision();
    if (branch(law) == Branch::only) {
      return oracles::second_order_of_arms(c, {colliding_impulse(law)});
    }
    // F = (1 + ε) P_I + κ (P_II − P_I) with κ ≤ 1 + e_t.
    const double share = 1 + c.tangential_restitution;
    return oracles::second_order_of_arms(
        c, {(1 + c.restitution + share) * stop_impulses().of_approach, share * stop_impulses().of_point});
  });
}

const Sensitivity& ExactCase::second_order_from_rest() const {
  return second_order_from_rest_.get(
      [this] { return oracles::second_order_from_rest(collision(), normal_velocity_sensitivity()); });
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
    if (is_moderate() && is_well_conditioned() && has_clear_divisor(branch)) {
      if (const auto known = oracles::colliding_sensitivity(collision(), law, branch)) {
        return *known;
      }
    }
    if (const auto known = enclosed_sensitivity(collision(), law, branch, is_moderate())) {
      return *known;
    }
    return exact_sensitivity(collision(), law, branch);
  });
}

bool ExactCase::is_moderate(Law law) const {
  return is_moderate() && (state() == ContactState::inert || has_clear_divisor(branch(law)));
}

const Sensitivity& ExactCase::sensitivity_below(Law law) const {
  CAROM_EXPECTS(is_moderate(law), law);
  if (state() != ContactState::colliding) {
    return norms_before();
  }
  return of(law).sensitivity_below.get([&] {
    const Outcome<Enclosure>& outcome = colliding_truth(law).outcome;
    return per_vector([&](OutcomeVector k) { return norms_before()[k] + norm_below(*vectors(outcome)[k]) / 2; });
  });
}

const Matrix3<Rational>& ExactCase::collision_matrix() const {
  return collision_matrix_.get([this] { return response_matrix(exact()); });
}

const Matrix3<Enclosure>& ExactCase::enclosed_collision_matrix() const {
  return enclosed_collision_matrix_.get([this] { return response_matrix(enclosed()); });
}

bool ExactCase::is_well_conditioned() const {
  constexpr double well_conditioned = 1 << 20;
  return condition_bound(enclosed_collision_matrix()) < well_conditioned;
}

double ExactCase::collision_matrix_sensitivity(double allowance) const {
  const double first_order = collision_matrix_sensitivity_.get([this] {
    const auto k = response_matrix(differentiated().collision);
    return sensitivity_of({&k(0, 0), &k(0, 1), &k(0, 2), &k(1, 0), &k(1, 1), &k(1, 2), &k(2, 0), &k(2, 1), &k(2, 2)},
                          differentiated().quantities);
  });
  const PermittedInputs* permitted = permitted_inputs(allowance);
  return first_order + (permitted != nullptr ? permitted->second_order_of_matrix() / allowance : 0);
}

double ExactCase::collision_matrix_sensitivity_below() const {
  CAROM_EXPECTS(is_moderate());
  return collision_matrix_sensitivity_below_.get([this] {
    double largest_terms{};
    for (const Body* body : {&collision_.a, &collision_.b}) {
      if (!body->immovable) {
        largest_terms += lever_arm(*body, collision_.point).squaredNorm() / body->principal_inertia.minCoeff();
      }
    }
    const double norm = norm_below(enclosed_collision_matrix());
    const double lambda = inverse_mass(enclosed()).magnitude_below();
    return norm >= exact_case_bounds::least_share_of_largest_terms * largest_terms ? std::max(norm, lambda) / 2
                                                                                   : lambda / 2;
  });
}

bool ExactCase::is_definite() const {
  return is_definite_.get([this] {
    const auto by_enclosures = [this] {
      return is_positive_semidefinite(
          less_multiple_of_identity<Enclosure>(enclosed_collision_matrix(), inverse_mass(enclosed())));
    };
    const std::optional<bool> decided = filtered_ ? by_enclosures() : std::nullopt;
    return decided ? *decided : is_at_least(collision_matrix(), inverse_mass(exact()));
  });
}

bool ExactCase::is_bounded_by(const Rational& bound) const {
  const auto by_enclosures = [&] {
    return is_positive_semidefinite(
        less_multiple_of_identity<Enclosure>(-enclosed_collision_matrix(), Enclosure(Rational(-bound))));
  };
  const std::optional<bool> decided = filtered_ ? by_enclosures() : std::nullopt;
  return decided ? *decided : is_at_most(collision_matrix(), bound);
}

bool ExactCase::is_collinear() const {
  return is_collinear_.get([this] {
    const auto is_along_normal = [&](BasicBody<Rational> BasicCollision<Rational>::*exact_body,
                                     BasicBody<Enclosure> BasicCollision<Enclosure>::*near_body) {
      const BasicCollision<Enclosure>& near = enclosed();
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
      return Vector3<T>(c.normal.cross(oracles::relative_velocity<T>(c, unchanged(c))));
    };
    return !(filtered_ && is_surely_not_zero(tangential(enclosed()))) && is_zero(tangential(exact()));
  });
}

}  // namespace carom::oracles
