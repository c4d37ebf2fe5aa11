// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/collision/expects.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/laws/mechanics.hpp>
#include <carom/oracles/truths/superposition.hpp>

namespace carom::oracles {
namespace {

constexpr double most_feedback = 0.5;
/// T/λ for K ⪯ T (`growth_in_collision_matrix`). Binary64 then knows K within 2⁻³⁰ λ.
constexpr double most_growth = 0x1p20;

/// The sizes of K that `friction_feedback` names, and its result.
struct FrictionNumbers {
  double norm;    // ‖K‖
  double normal;  // K_NN
  double coupling;
  double least;
  double greatest;
  double feedback;
};

FrictionNumbers friction_numbers(const Collision& c) {
  const Vector3<double> n = c.normal / norm_of(c.normal);
  int axis = 0;
  n.cwiseAbs().minCoeff(&axis);
  const Vector3<double> first = n.cross(Vector3<double>::Unit(axis)).normalized();
  Matrix3<double> basis;
  basis << n, first, n.cross(first);
  const Matrix3<double> k = basis.transpose() * response_matrix<double>(c) * basis;
  using Vector2 = Eigen::Matrix<double, 2, 1>;
  using Matrix2 = Eigen::Matrix<double, 2, 2>;
  const Vector2 coupling = k.col(0).tail<2>() / k(0, 0);
  const Matrix2 across = k.bottomRightCorner<2, 2>() - k(0, 0) * coupling * coupling.transpose();
  const double greatest = across.trace() / 2 + std::hypot((across(0, 0) - across(1, 1)) / 2, across(0, 1));
  const double least = across.determinant() / greatest;
  const double size = coupling.norm();
  return {k.norm(), k(0, 0), size, least, greatest, friction_feedback(c.friction, size, least, greatest)};
}

/// (1 + ε) ‖V⁻‖ / λ, which bounds the impulse, because λI ⪯ K.
double impulse_bound(const Collision& c, double speed) { return (1 + c.restitution) * speed / inverse_mass<double>(c); }

double speed_before(const Collision& c) { return norm_of(relative_velocity<double>(c, unchanged(c))); }

/// The Frobenius norm of the derivative of a vector by itself.
const double of_identity = std::sqrt(3.0);

/// Σ_q ‖∂V⁻/∂q‖ ‖q‖, or more.
double velocity_sensitivity(const Collision& c) {
  double sum = 0;
  for (const Body* body : {&c.a, &c.b}) {
    const double arms = norm_of(lever_arm(*body, c.point)) + length_of_lever_arm(*body, c.point);
    sum += norm_of(body->velocity) + norm_of(body->angular_velocity) * arms;
  }
  return of_identity * sum;
}

/// The sensitivity of an outcome if the impulse has this length, and a relative change of the inputs changes it by at
/// most `change` times this. J⁻¹ (r × F) with J = R diag(I) Rᵀ also changes with I, with R, which turns by twice the
/// change of the quaternion, and with r.
Sensitivity sensitivity_by(const Collision& c, double impulse, double change) {
  const double by_inertia = of_identity + 2 * 2 * std::sqrt(2.0);
  Sensitivity sum{};
  const auto add_body = [&](const Body& body, OutcomeVector velocity, OutcomeVector spin) {
    sum[velocity] = (1 + of_identity) * norm_of(body.velocity);
    sum[spin] = (1 + of_identity) * norm_of(body.angular_velocity);
    if (!body.immovable) {
      const double arm = norm_of(lever_arm(body, c.point));
      sum[velocity] += (impulse + change) / body.mass;
      sum[spin] += ((by_inertia * arm + std::sqrt(2.0) * length_of_lever_arm(body, c.point)) * impulse + arm * change) /
                   body.principal_inertia.minCoeff();
    }
  };
  add_body(c.a, OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a);
  add_body(c.b, OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b);
  return sum;
}

bool may_collide(const ExactCase& exact_case, double allowance) {
  return exact_case.state() == ContactState::colliding || exact_case.is_grazing(allowance);
}

}  // namespace

std::vector<CoulombAnswer> coulomb_answers(const ExactCase& exact_case) {
  if (exact_case.state() == ContactState::colliding) {
    return coulomb_answers(exact_case.exact());
  }
  return {{AnswerKind::untouched, exact_case.truth(Law::frictionless)}};
}

bool has_one_coulomb_answer(const ExactCase& exact_case, double allowance) {
  if (!may_collide(exact_case, allowance)) {
    return true;
  }
  const Collision& c = exact_case.collision();
  return exact_case.is_moderate() && exact_case.permitted_inputs(allowance) == nullptr &&
         growth_in_collision_matrix(c) <= most_growth && friction_numbers(c).feedback <= most_feedback;
}

std::optional<Sensitivity> coulomb_sensitivity(const ExactCase& exact_case, double allowance) {
  if (!may_collide(exact_case, allowance)) {
    return exact_case.sensitivity_as(Law::frictionless, exact_case.state(), allowance);
  }
  const Collision& c = exact_case.collision();
  const FrictionNumbers of = friction_numbers(c);
  const double speed = speed_before(c);
  const double of_velocity = velocity_sensitivity(c);
  const double impulse = impulse_bound(c, speed + allowance * of_velocity);
  // A turn of N/‖N‖ is a turn of all else, and of the impulse. Its derivative by N is (I − n nᵀ) / ‖N‖.
  const double turn = std::sqrt(2.0);
  const double of_matrix = exact_case.collision_matrix_sensitivity(allowance) + 2 * turn * of.norm;
  const double condition = of.greatest / of.least;
  // Permitted inputs change K_NN and S by at most this share, and the feedback by less than three times `doubt`.
  const double share = allowance * of_matrix / std::min(of.normal, of.least);
  const double doubt = share * (1 + of.coupling) * (1 + c.friction * condition);
  if (!(doubt <= 1.0 / 8)) {
    return std::nullopt;
  }
  // With a fixed impulse, K F + V⁻ and the wanted N·V⁺ change by at most `missed`. With a fixed F_T, so do F_n by
  // missed / K_NN, and S F_T + a by (1 + ‖c‖) times it. The disc of F_T grows by the change of μ F_n.
  const double missed =
      of_matrix * impulse + (1 + c.restitution) * (of_velocity + turn * speed) + c.restitution * speed;
  const double limit = c.friction * (impulse + missed / of.normal);
  const double tangential = ((1 + of.coupling) * missed / of.least + condition * limit) / (1 - of.feedback - 3 * doubt);
  const double normal = missed / of.normal + of.coupling * tangential;
  Sensitivity sum = sensitivity_by(c, impulse, tangential + normal + turn * impulse);
  const Sensitivity second = second_order(c);
  for (const OutcomeVector k : all_outcome_vectors) {
    sum[k] += allowance * second[k];
  }
  return sum;
}

Sensitivity coulomb_sensitivity_below(const ExactCase& exact_case) {
  const Collision& c = exact_case.collision();
  return exact_case.state() == ContactState::colliding ? sensitivity_by(c, impulse_bound(c, speed_before(c)), 0)
                                                       : exact_case.norms_before();
}

NearestAnswer nearest_answer(const ExactCase& exact_case, const std::vector<CoulombAnswer>& answers,
                             const Outcome<long double>& outcome) {
  CAROM_EXPECTS(!answers.empty() && is_finite(outcome), answers.size());
  const Outcome<Rational> exact = lift(outcome);
  NearestAnswer nearest{0, -HUGE_VAL};
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const double digits = digits_of(exact_case.exact(), answers[i].truth.outcome, exact);
    if (digits > nearest.digits) {
      nearest = {i, digits};
    }
  }
  return nearest;
}

}  // namespace carom::oracles
