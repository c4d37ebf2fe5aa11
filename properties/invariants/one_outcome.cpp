// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include <carom/oracles/bounds/stage.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/properties/invariants/invariant_groups.hpp>
#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {
namespace {

namespace equation = oracles::equation;
using oracles::compare;
using oracles::ContactState;
using oracles::EquationForm;
using oracles::Rational;

bool collides(const Evidence& e) { return e.exact_case.state() == ContactState::colliding; }

/// Applies `check` to contacts with a movable body.
template <Verdict (*check)(const Evidence&)>
Verdict if_movable(const Evidence& e) {
  return e.exact_case.state() == ContactState::inert ? does_not_apply("both bodies are immovable") : check(e);
}

Verdict holds(const Evidence& e, EquationForm form, const char* what, const oracles::Equation& equation) {
  return verdict_of(compare(equation, form, e.exact_case, e.outcome, e.yardstick), what);
}

const Body& body(const Evidence& e, bool a) { return a ? e.exact_case.collision().a : e.exact_case.collision().b; }

Verdict untouched_body(const Evidence& e, bool a) {
  const char* what = a ? "velocities of A, after and before" : "velocities of B, after and before";
  const auto [velocity, angular_velocity] = vectors_of_body(a);
  return both(holds(e, EquationForm::equal, what, equation::Untouched{velocity}),
              holds(e, EquationForm::equal, what, equation::Untouched{angular_velocity}));
}

Verdict check_linear_momentum(const Evidence& e) {
  if (body(e, true).immovable || body(e, false).immovable) {
    return does_not_apply("a body is immovable");
  }
  return holds(e, EquationForm::equal, "m_A Δv_A and −m_B Δv_B", equation::LinearMomentum{});
}

Verdict check_angular_momentum(const Evidence& e) {
  Verdict worst = does_not_apply("both bodies are immovable");
  for (const bool a : {true, false}) {
    if (!body(e, a).immovable) {
      worst = both(std::move(worst),
                   holds(e, EquationForm::equal, a ? "J_A Δw_A and r_A × m_A Δv_A" : "J_B Δw_B and r_B × m_B Δv_B",
                         equation::AngularMomentum{a}));
    }
  }
  if (!body(e, true).immovable && !body(e, false).immovable) {
    worst = both(std::move(worst),
                 holds(e, EquationForm::equal, "angular momentum about the origin: the gain of A and the loss of B",
                       equation::TotalAngularMomentum{}));
  }
  return worst;
}

Verdict check_restitution(const Evidence& e) {
  if (!collides(e)) {
    return does_not_apply("the contact is not colliding");
  }
  return holds(e, EquationForm::equal, "N·V⁺ and −ε N·V⁻", equation::Restitution{});
}

Verdict check_non_penetration(const Evidence& e) {
  return holds(e, EquationForm::at_least, "N·V⁺ and 0", equation::NonPenetration{});
}

Verdict check_parting_speed(const Evidence& e) {
  const auto by_sign = [&](bool is_colliding) {
    return holds(e, EquationForm::at_most, "N·V⁺ and |N·V⁻|", equation::PartingSpeed{is_colliding});
  };
  // The inputs that make the outcome exact may lie on the other side of N·V⁻ = 0.
  Verdict own = by_sign(collides(e));
  const bool may_be_other = own.status == Status::violated && e.exact_case.is_grazing(e.allowance());
  return may_be_other && by_sign(!collides(e)).status == Status::holds ? Verdict{} : own;
}

const char* sides_of(oracles::ImpulseBoundOf bound) {
  constexpr std::array sides{"λ² ‖F‖² ‖N‖² and (1 + ε)² (N·V⁻)²", "λ² ‖F‖² and (1 + ε)² ‖V⁻‖²",
                             "λ² ‖F‖² and (1 + e_t)² ‖V⁻‖²"};
  return sides[static_cast<std::size_t>(bound)];
}

Verdict check_impulse_bound(const Evidence& e) {
  const Collision& c = e.exact_case.collision();
  const oracles::ImpulseBoundOf bound = oracles::impulse_bound_of(e.law, c);
  return holds(e, EquationForm::at_most, sides_of(bound),
               equation::ImpulseBound{bound, oracles::reads_impulse_off_a(c)});
}

/// The verdict if `accuracy` is not decided. At a contact with several answers, what these answers share decides.
Verdict check_undecided(const Evidence& e) {
  return e.exact_case.is_open(e.law, e.allowance())
             ? both(if_movable<check_parting_speed>(e), if_movable<check_impulse_bound>(e))
             : beyond_range();
}

Verdict check_backward_error(const Evidence& e) {
  const oracles::Accuracy& accuracy = *e.accuracy;
  if (!accuracy.is_decided) {
    return check_undecided(e);
  }
  const bool enough_digits = accuracy.has_digits.value_or(false);
  const PerVector<double> noise = oracles::permitted_noise(e.exact_case.collision(), e.yardstick);
  Verdict worst;
  for (const OutcomeVector k : all_outcome_vectors) {
    if (accuracy.allowed[k] || enough_digits) {
      continue;
    }
    Verdict verdict{Status::violated,
                    fmt::format("{}, computed and exact", name_of(k)),
                    accuracy.error[k],
                    e.allowance() * accuracy.sensitivity[k] + noise[k],
                    {},
                    {}};
    const auto show = [&](const auto& truth) {
      for (int i = 0; i < 3; ++i) {
        verdict.left.push_back((*vectors(e.outcome.rounded())[k])[i]);
        verdict.right.push_back(rounded_for_print((*vectors(truth.outcome)[k])[i]));
      }
    };
    if (e.yardstick.filtered()) {
      show(e.exact_case.enclosed_truth(e.law));
    } else {
      e.exact_case.with_truth(e.law, e.exact_case.state(), show);
    }
    worst = both(std::move(worst), std::move(verdict));
  }
  return worst;
}

Verdict check_push(const Evidence& e) {
  Verdict verdict = holds(e, EquationForm::at_least, "N·F and 0",
                          equation::Push{oracles::reads_impulse_off_a(e.exact_case.collision())});
  // At a grazing contact, the rounding of the inputs decides the sign of N·V⁻, which the residual of `push` does not
  // contain. So the accuracy decides.
  const bool is_allowed = verdict.status == Status::violated && e.accuracy != nullptr && e.accuracy->is_decided &&
                          e.accuracy->is_allowed() && e.exact_case.is_grazing(e.allowance());
  return is_allowed ? Verdict{} : verdict;
}

/// Whether permitted inputs collide and others separate, and the law may act at once (`ExactCase::has_two_answers`). A
/// law without a truth may do so at each grazing contact.
bool may_act_at_once(const Evidence& e) {
  return determines_outcome(e.law) ? has_two_answers(e, e.exact_case) : e.exact_case.is_grazing(e.allowance());
}

Verdict vectors_untouched(const Evidence& e, std::span<const OutcomeVector> which) {
  if (is_surely_untouched(e.exact_case, e.outcome, e.yardstick, which)) {
    return {};
  }
  const oracles::Sensitivity sensitivity = e.exact_case.sensitivity_with_noise(e.law, e.yardstick);
  Verdict worst;
  for (const OutcomeVector k : which) {
    worst = both(std::move(worst), vector_untouched(e, k, sensitivity));
  }
  return worst;
}

Verdict untouched_bodies(const Evidence& e) {
  if (!determines_outcome(e.law)) {
    return both(untouched_body(e, true), untouched_body(e, false));
  }
  return vectors_untouched(e, all_outcome_vectors);
}

Verdict check_separating_untouched(const Evidence& e) {
  if (collides(e)) {
    return does_not_apply("the contact is colliding");
  }
  Verdict untouched = untouched_bodies(e);
  // An outcome may be that of either side. Both sides share the bound of the impulse. `backward_error`, `sticks` and
  // `slip_opposed` judge the rest.
  return untouched.status == Status::violated && may_act_at_once(e) ? if_movable<check_impulse_bound>(e) : untouched;
}

Verdict check_immovable_untouched(const Evidence& e) {
  Verdict worst = does_not_apply("both bodies are movable");
  for (const bool a : {true, false}) {
    if (body(e, a).immovable) {
      worst = both(std::move(worst), untouched_body(e, a));
    }
  }
  return worst;
}

Verdict check_frictionless_direction(const Evidence& e) {
  return holds(e, EquationForm::equal, "N × F and 0",
               equation::FrictionlessDirection{oracles::reads_impulse_off_a(e.exact_case.collision())});
}

Verdict check_reflection_plane(const Evidence& e) {
  return holds(e, EquationForm::equal, "N × V⁺ and N × V⁻", equation::ReflectionPlane{});
}

Verdict check_sticks(const Evidence& e) {
  if (!collides(e)) {
    return does_not_apply("the contact is not colliding");
  }
  Verdict sticks = holds(e, EquationForm::equal, "N × V⁺ and 0", equation::Sticks{});
  const bool may_be_untouched = sticks.status == Status::violated && may_act_at_once(e);
  return may_be_untouched && untouched_bodies(e).status == Status::holds ? Verdict{} : sticks;
}

Verdict check_friction_cone(const Evidence& e) {
  return both(check_push(e), holds(e, EquationForm::at_most, "‖N × F‖² and (μ N·F)²",
                                   equation::FrictionCone{oracles::reads_impulse_off_a(e.exact_case.collision())}));
}

/// Bodies that the impulse leaves alone satisfy the statement, so it applies to contacts that do not collide, too.
Verdict check_slip_opposed(const Evidence& e) {
  Verdict sticks = holds(e, EquationForm::equal, "N × V⁺ and 0", equation::Sticks{});
  if (sticks.status != Status::violated) {  // it holds, or cannot be decided
    return sticks;
  }
  const bool off_a = oracles::reads_impulse_off_a(e.exact_case.collision());
  return both(both(holds(e, EquationForm::equal, "‖N × F‖² and (μ N·F)²; the contact point slips",
                         equation::FrictionCone{off_a}),
                   holds(e, EquationForm::equal, "(N × F) × (N × V⁺) and 0", equation::FrictionAlongSlip{off_a})),
              holds(e, EquationForm::at_most, "(N × F)·(N × V⁺) and 0", equation::FrictionAgainstSlip{off_a}));
}

Verdict check_energy(const Evidence& e) {
  return holds(e, EquationForm::at_most, "E⁺ − E⁻ and the work of the wall", equation::Energy{});
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Invariant> outcome_invariants() {
  return {
      Invariant{
          "backward_error", "The error of each velocity is at most what inputs within the limit can cause.",
          R"(\eta = \max_k \frac{\lVert \hat y_k - y_k \rVert}{u \left(\sum_q \lVert \partial y_k / \partial q \rVert\, \lVert q \rVert + \lVert y_k^- \rVert\right)} \le \eta_{\max})",
          "mixed forward-backward error, N. Higham, Accuracy and Stability of Numerical Algorithms, §1.5; y is exact",
          "valid collisions", with_truth(), AboutOutcome{check_backward_error, true, true}},
      Invariant{"linear_momentum", "A gains the linear momentum that B loses.",
                R"(m_A (v_A^+ - v_A^-) = -m_B (v_B^+ - v_B^-))", "note eq. 23", "contacts of two movable bodies",
                every_law(), AboutOutcome{check_linear_momentum, true},
                Proof{ProvedOf::every_impulse, {{"linear_momentum", "momentum.v"}}}, 6,
                [](const Kinds& kinds) { return kinds.movable == Movable::any || kinds.movable == Movable::both; }},
      Invariant{"angular_momentum",
                "The change of each movable body's angular momentum is the moment of its impulse; the total angular "
                "momentum about every point is conserved.",
                R"(J (w^+ - w^-) = r \times m (v^+ - v^-))", "note eq. 11, 23", "contacts with a movable body",
                every_law(), AboutOutcome{check_angular_momentum, true},
                Proof{ProvedOf::every_impulse,
                      {{"angular_momentum", "momentum.v"}, {"angular_momentum_of_each", "momentum.v"}}},
                7},
      Invariant{"restitution", "The normal velocity is reversed and multiplied by ε.",
                R"(N \cdot V^+ = -\varepsilon\, N \cdot V^-)", "note eq. 17", "colliding contacts", every_law(),
                AboutOutcome{check_restitution, true},
                Proof{ProvedOf::its_laws,
                      {{"restitution_of_every_law", "every_law.v"},
                       {"restitution_of_frictionless", "laws_of_impulse.v"},
                       {"restitution_of_reflection", "laws_of_impulse.v"},
                       {"restitution_of_sticking", "laws_of_impulse.v"},
                       {"restitution_of_rough_law", "friction.v"}}},
                14},
      Invariant{"non_penetration", "After the impulse, the bodies do not approach.", R"(N \cdot V^+ \ge 0)",
                "note §1, after eq. 4", "contacts with a movable body", every_law(),
                AboutOutcome{if_movable<check_non_penetration>, true},
                Proof{ProvedOf::its_laws,
                      {{"non_penetration_of_every_law", "every_law.v"}, {"non_penetration", "laws_of_impulse.v"}}},
                15},
      Invariant{"parting_speed", "The bodies part no faster than they met.", R"(N \cdot V^+ \le |N \cdot V^-|)",
                "restitution with 0 ≤ ε ≤ 1, or an outcome without an impulse; failure case 45",
                "contacts with a movable body", every_law(), AboutOutcome{if_movable<check_parting_speed>},
                Proof{ProvedOf::every_impulse, {{"parts_no_faster_than_they_met", "every_law.v"}}}, 17},
      Invariant{
          "impulse_bound",
          "The normal velocity or the velocity before the impulse bounds the impulse; bodies at rest stay at rest.",
          R"(\lambda \lVert F \rVert \le (1 + \varepsilon)\, |N \cdot V^-| / \lVert N \rVert \ \text{(frictionless, reflection)},\quad \lambda \lVert F \rVert \le (1 + \varepsilon) \lVert V^- \rVert \ \text{(sticking, coulomb)},\quad \lambda \lVert F \rVert \le (1 + \max(\varepsilon, e_t)) \lVert V^- \rVert \ \text{(rough, any)},\quad \lambda = 1/m_A + 1/m_B)",
          "each law's demand on V⁺, with λI ⪯ C; failure case 45", "contacts with a movable body", every_law(),
          AboutOutcome{if_movable<check_impulse_bound>},
          Proof{ProvedOf::every_impulse,
                {{"impulse_bound_of_frictionless", "impulse_bound.v"},
                 {"impulse_bound_of_reflection", "impulse_bound.v"},
                 {"impulse_bound_of_sticking", "impulse_bound.v"},
                 {"impulse_bound_of_coulomb", "impulse_bound.v"},
                 {"impulse_bound_of_rough", "impulse_bound.v"},
                 {"impulse_bound_of_every_law", "impulse_bound.v"},
                 {"bounded_impulse_at_rest", "impulse_bound.v"},
                 {"rest_stays_at_rest", "impulse_bound.v"}}},
          18},
      Invariant{"push", "The impulse pushes the bodies apart and never pulls them together.", R"(N \cdot F \ge 0)",
                "note eq. 18, with C positive definite", "contacts with a movable body",
                std::vector{Law::frictionless, Law::reflection, Law::rough, Law::coulomb},
                AboutOutcome{if_movable<check_push>, true},
                Proof{ProvedOf::its_laws,
                      {{"push_of_frictionless", "laws_of_impulse.v"},
                       {"push_of_reflection", "laws_of_impulse.v"},
                       {"push_of_rough", "friction.v"}}},
                16},
      Invariant{"separating_untouched", "A contact that is not colliding keeps its velocities.",
                R"(N \cdot V^- \ge 0 \Rightarrow y = (v_A^-, w_A^-, v_B^-, w_B^-))", "note §1, after eq. 2",
                "separating and resting contacts, and two immovable bodies", every_law(),
                AboutOutcome{check_separating_untouched},
                Proof{ProvedOf::every_impulse, {{"separating_untouched", "laws_of_impulse.v"}}}, 5},
      Invariant{"immovable_untouched", "A body of infinite mass keeps its velocity.",
                R"(1/m = 0 \Rightarrow v^+ = v^-,\ w^+ = w^-)", "protocol; failure cases 26, 27",
                "contacts with an immovable body", every_law(), AboutOutcome{check_immovable_untouched},
                Proof{ProvedOf::every_impulse, {{"immovable_untouched", "laws_of_impulse.v"}}}, 4,
                [](const Kinds& kinds) { return kinds.movable != Movable::both; }},
      Invariant{"frictionless_direction",
                "The impulse is along the normal.",
                R"(N \times F = 0)",
                "note eq. 10",
                "contacts with a movable body",
                {Law::frictionless},
                AboutOutcome{if_movable<check_frictionless_direction>},
                Proof{ProvedOf::its_laws, {{"frictionless_direction", "laws_of_impulse.v"}}},
                9},
      Invariant{"reflection_plane",
                "The tangential relative velocity of the contact point does not change.",
                R"(N \times V^+ = N \times V^-)",
                "note eq. 20, 21",
                "contacts with a movable body",
                {Law::reflection},
                AboutOutcome{if_movable<check_reflection_plane>},
                Proof{ProvedOf::its_laws, {{"reflection_plane", "laws_of_impulse.v"}}},
                10},
      Invariant{"sticks",
                "The tangential relative velocity of the contact point is zero after the impulse.",
                R"(N \times V^+ = 0)",
                "the limit μ → ∞ of Coulomb friction",
                "colliding contacts",
                {Law::sticking},
                AboutOutcome{check_sticks},
                Proof{ProvedOf::its_laws, {{"sticks", "laws_of_impulse.v"}}},
                11},
      Invariant{"friction_cone",
                "The impulse lies in the friction cone about the normal.",
                R"(\lVert N \times F \rVert \le \mu\, N \cdot F)",
                "Coulomb friction; A. Chatterjee, A. Ruina, J. Appl. Mech. 65 (1998)",
                "contacts with a movable body",
                {Law::rough, Law::coulomb},
                AboutOutcome{if_movable<check_friction_cone>},
                Proof{ProvedOf::its_laws, {{"friction_cone", "friction.v"}}},
                12},
      Invariant{
          "slip_opposed",
          "The contact point sticks, or the friction impulse is on the friction cone and opposes the slip after the "
          "impulse.",
          R"(N \times V^+ = 0 \ \lor\ \lVert N \times V^+ \rVert\, (N \times F) = -\mu\, (N \cdot F)\, (N \times V^+))",
          "Coulomb friction; docs: the laws",
          "contacts with a movable body",
          {Law::coulomb},
          AboutOutcome{if_movable<check_slip_opposed>},
          Proof{},
          13},
      Invariant{"energy",
                "The kinetic energy grows by at most the work of a driven wall.",
                R"(E^+ - E^- \le W,\quad E = \tfrac12 m v^2 + \tfrac12 w^\top J w)",
                "ΔE = −(1−ε²)(N·V⁻)²/(2 NᵀKN) for the frictionless law; the rough law adds −½ κ (2−κ) DᵀKD with 0 ≤ κ "
                "≤ 2. Reflection and sticking can create energy, so they do not claim this invariant",
                "contacts with a movable body",
                {Law::frictionless, Law::rough},
                AboutOutcome{if_movable<check_energy>},
                Proof{ProvedOf::its_laws,
                      {{"energy_of_frictionless", "energy.v"},
                       {"energy_of_rough_law", "friction.v"},
                       {"energy_of_frictionless_with_driven_walls", "driven_walls.v"},
                       {"energy_of_rough_with_driven_walls", "driven_walls.v"}}}}};
}

namespace {

Verdict check_collinear_spin(const Evidence& e) {
  if (e.exact_case.state() != oracles::ContactState::colliding) {
    return does_not_apply("the contact is not colliding");
  }
  if (!e.exact_case.is_collinear()) {
    return does_not_apply("a lever arm is not along the normal");
  }
  constexpr std::array spins{OutcomeVector::angular_velocity_of_a, OutcomeVector::angular_velocity_of_b};
  return vectors_untouched(e, spins);
}

}  // namespace

std::vector<Invariant> collinear_spin_invariants() {
  return {Invariant{"collinear_spin",
                    "If both lever arms are along the normal, as for spheres, no body changes its spin.",
                    R"(r_A \times N = r_B \times N = 0 \Rightarrow w_A^+ = w_A^-,\ w_B^+ = w_B^-)", "note eq. 19",
                    "colliding contacts with both lever arms exactly along the normal",
                    std::vector{Law::frictionless, Law::reflection}, AboutOutcome{check_collinear_spin},
                    Proof{ProvedOf::its_laws,
                          {{"collinear_spin_of_frictionless", "laws_of_impulse.v"},
                           {"collinear_spin_of_reflection", "laws_of_impulse.v"}}}}};
}

}  // namespace carom::properties
