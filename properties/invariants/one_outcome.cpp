// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include <carom/oracles/filters/stage.hpp>
#include <carom/properties/invariants/checks.hpp>
#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {
namespace {

namespace equation = oracles::equation;
using oracles::Approach;
using oracles::compare;
using oracles::Rational;
using oracles::Relation;

constexpr std::array spins{OutcomeVector::angular_velocity_of_a, OutcomeVector::angular_velocity_of_b};

bool collides(const Evidence& e) { return e.exact_case.approach() == Approach::colliding; }

bool is_inert(const Evidence& e) { return e.exact_case.approach() == Approach::inert; }

/// The verdict of one equation.
Verdict holds(const Evidence& e, Relation relation, const char* what, const oracles::Equation& equation) {
  if (e.closeness.shows(equation)) {
    count(oracles::Stage::closeness);
    return {};
  }
  return verdict_of(compare(equation, relation, e.exact_case, e.outcome, e.yardstick), what);
}

const Body& body(const Evidence& e, bool a) { return a ? e.exact_case.collision().a : e.exact_case.collision().b; }

Verdict untouched_body(const Evidence& e, bool a) {
  return holds(e, Relation::equal, a ? "velocities of A, after and before" : "velocities of B, after and before",
               equation::Untouched{a});
}

/// One vector of the outcome against the same before the impulse, allowed what the law's sensitivity allows.
Verdict vector_untouched(const Evidence& e, OutcomeVector k, const oracles::Sensitivity& sensitivity) {
  const auto before = unchanged(e.exact_case.bounds().enclosed());
  const auto exact_pair = [&] {
    const auto exactly_before = unchanged(e.exact_case.exact());
    return std::pair{*vectors(e.outcome.exact())[k], *vectors(exactly_before)[k]};
  };
  return vector_equals(*vectors(e.outcome.enclosed())[k], *vectors(before)[k], exact_pair,
                       e.yardstick.allowed(sensitivity[k]), e.yardstick.filtered, name_of(k), "after and before");
}

/// Whether the closeness to the truth, which leaves these vectors untouched, or bounds show that they are so.
bool are_surely_untouched(const Evidence& e, std::span<const OutcomeVector> which) {
  if (e.closeness.shows_untouched(which)) {
    count(oracles::Stage::closeness);
    return true;
  }
  return is_surely_untouched(e.exact_case, e.outcome, e.yardstick, which);
}

}  // namespace

Verdict check_backward_error(const Evidence& e) {
  const oracles::Accuracy& accuracy = *e.accuracy;
  if (!accuracy.is_decided) {
    return beyond_range();
  }
  const bool enough_digits = e.yardstick.digits && accuracy.has_digits;
  Verdict worst;
  for (const OutcomeVector k : all_outcome_vectors) {
    if (accuracy.allowed[k] || enough_digits) {
      continue;
    }
    Verdict verdict{Status::violated,
                    fmt::format("{}, computed and exact", name_of(k)),
                    accuracy.error[k],
                    e.allowance() * accuracy.sensitivity[k],
                    {},
                    {}};
    const auto show = [&](const auto& truth) {
      for (int i = 0; i < 3; ++i) {
        verdict.left.push_back((*vectors(e.outcome.rounded())[k])[i]);
        verdict.right.push_back(oracles::rounded((*vectors(truth.outcome)[k])[i]));
      }
    };
    if (e.yardstick.filtered) {
      show(e.exact_case.enclosed_truth(e.model));
    } else {
      show(e.exact_case.truth(e.model));
    }
    worst = both(std::move(worst), std::move(verdict));
  }
  return worst;
}

Verdict check_linear_momentum(const Evidence& e) {
  if (body(e, true).immovable || body(e, false).immovable) {
    return outside_domain("a body is immovable");
  }
  return holds(e, Relation::equal, "m_A Δv_A and −m_B Δv_B", equation::LinearMomentum{});
}

Verdict check_angular_momentum(const Evidence& e) {
  Verdict worst = outside_domain("both bodies are immovable");
  for (const bool a : {true, false}) {
    if (!body(e, a).immovable) {
      worst = both(std::move(worst),
                   holds(e, Relation::equal, a ? "J_A Δw_A and r_A × m_A Δv_A" : "J_B Δw_B and r_B × m_B Δv_B",
                         equation::AngularMomentum{a}));
    }
  }
  if (!body(e, true).immovable && !body(e, false).immovable) {
    worst =
        both(std::move(worst), holds(e, Relation::equal, "angular momentum about the origin: what A gains and B loses",
                                     equation::TotalAngularMomentum{}));
  }
  return worst;
}

Verdict check_restitution(const Evidence& e) {
  if (!collides(e)) {
    return outside_domain("the contact is not colliding");
  }
  return holds(e, Relation::equal, "N·V⁺ and −ε N·V⁻", equation::Restitution{});
}

Verdict check_non_penetration(const Evidence& e) {
  if (is_inert(e)) {
    return outside_domain("both bodies are immovable");
  }
  return holds(e, Relation::at_least, "N·V⁺ and 0", equation::NonPenetration{});
}

Verdict check_push(const Evidence& e) {
  if (is_inert(e)) {
    return outside_domain("both bodies are immovable");
  }
  Verdict verdict =
      holds(e, Relation::at_least, "N·F and 0", equation::Push{oracles::reads_impulse_off_a(e.exact_case.collision())});
  // A residual over the outputs alone knows nothing of the inputs' rounding, which decides the sign of N·V⁻ there.
  if (verdict.status == Status::violated && e.exact_case.is_grazing(e.allowance())) {
    if (e.accuracy == nullptr) {
      return outside_domain("within rounding of a separating contact");
    }
    if (!e.accuracy->is_decided) {
      return beyond_range();
    }
    if (e.accuracy->is_allowed()) {
      return {};
    }
  }
  return verdict;
}

Verdict check_separating_untouched(const Evidence& e) {
  if (collides(e)) {
    return outside_domain("the contact is colliding");
  }
  if (e.model == Model::any) {
    // Within rounding of a colliding contact an unknown law may act, and what it allows is not known.
    if (e.exact_case.is_grazing(e.allowance())) {
      return outside_domain("within rounding of a colliding contact");
    }
    return both(untouched_body(e, true), untouched_body(e, false));
  }
  if (are_surely_untouched(e, all_outcome_vectors)) {
    return {};
  }
  const oracles::Sensitivity& sensitivity = e.exact_case.sensitivity(e.model, e.allowance());
  Verdict worst;
  for (const OutcomeVector k : all_outcome_vectors) {
    worst = both(std::move(worst), vector_untouched(e, k, sensitivity));
  }
  return worst;
}

Verdict check_immovable_untouched(const Evidence& e) {
  Verdict worst = outside_domain("both bodies are movable");
  for (const bool a : {true, false}) {
    if (body(e, a).immovable) {
      worst = both(std::move(worst), untouched_body(e, a));
    }
  }
  return worst;
}

Verdict check_frictionless_direction(const Evidence& e) {
  if (is_inert(e)) {
    return outside_domain("both bodies are immovable");
  }
  return holds(e, Relation::equal, "N × F and 0",
               equation::FrictionlessDirection{oracles::reads_impulse_off_a(e.exact_case.collision())});
}

Verdict check_reflection_plane(const Evidence& e) {
  if (is_inert(e)) {
    return outside_domain("both bodies are immovable");
  }
  return holds(e, Relation::equal, "N × V⁺ and N × V⁻", equation::ReflectionPlane{});
}

Verdict check_energy(const Evidence& e) {
  if (is_inert(e)) {
    return outside_domain("both bodies are immovable");
  }
  if (e.closeness.shows_energy()) {
    count(oracles::Stage::closeness);
    return {};
  }
  return holds(e, Relation::at_most, "E⁺ − E⁻ and the work of the wall", equation::Energy{});
}

Verdict check_collinear_spin(const Evidence& e) {
  if (!collides(e)) {
    return outside_domain("the contact is not colliding");
  }
  if (!e.exact_case.is_collinear()) {
    return outside_domain("a lever arm is not along the normal");
  }
  if (are_surely_untouched(e, spins)) {
    return {};
  }
  const oracles::Sensitivity& sensitivity = e.exact_case.sensitivity(e.model, e.allowance());
  Verdict worst;
  for (const OutcomeVector k : spins) {
    worst = both(std::move(worst), vector_untouched(e, k, sensitivity));
  }
  return worst;
}

}  // namespace carom::properties
