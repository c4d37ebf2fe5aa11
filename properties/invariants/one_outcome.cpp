// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include <carom/oracles/filters/stage.hpp>
#include <carom/properties/invariants/checks.hpp>
#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {
namespace {

namespace law = oracles::law;
using oracles::Approach;
using oracles::compare;
using oracles::Rational;
using oracles::Relation;

bool collides(const Evidence& e) { return e.exact_case.approach() == Approach::colliding; }

bool is_inert(const Evidence& e) { return e.exact_case.approach() == Approach::inert; }

/// The verdict of one law.
template <class Law>
Verdict law_holds(const Evidence& e, Relation relation, const char* what, const Law& law) {
  const std::optional<oracles::AffineLaw> name = law.name();
  if (name && e.closeness.shows(*name)) {
    count(oracles::Stage::closeness);
    return {};
  }
  return verdict_of(compare(law, relation, e.exact_case, e.outcome, e.yardstick), what);
}

const Body& body(const Evidence& e, bool a) { return a ? e.exact_case.collision().a : e.exact_case.collision().b; }

Verdict untouched_body(const Evidence& e, bool a) {
  return law_holds(e, Relation::equal, a ? "velocities of A, after and before" : "velocities of B, after and before",
                   law::Untouched{a});
}

/// One vector of the outcome against the same before the impulse, allowed what the law's sensitivity allows.
Verdict vector_untouched(const Evidence& e, std::size_t k, const oracles::Sensitivity& sensitivity) {
  const auto before = unchanged(e.exact_case.enclosed());
  const auto exact_pair = [&] {
    const auto exactly_before = unchanged(e.exact_case.exact());
    return std::pair{*vectors(e.outcome.exact())[k], *vectors(exactly_before)[k]};
  };
  return vector_equals(*vectors(e.outcome.enclosed())[k], *vectors(before)[k], exact_pair,
                       e.yardstick.allowed(sensitivity[k]), e.yardstick.filtered, outcome_vector_names[k],
                       "after and before");
}

/// Whether the closeness to the truth, which leaves these vectors untouched, or bounds show that they are so.
bool are_surely_untouched(const Evidence& e, std::initializer_list<std::size_t> which) {
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
  for (std::size_t k = 0; k < accuracy.error.size() && !enough_digits; ++k) {
    if (accuracy.allowed[k]) {
      continue;
    }
    Verdict verdict{Status::violated,
                    fmt::format("{}, computed and exact", outcome_vector_names[k]),
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
  return law_holds(e, Relation::equal, "m_A Δv_A and −m_B Δv_B", law::LinearMomentum{});
}

Verdict check_angular_momentum(const Evidence& e) {
  Verdict worst = outside_domain("both bodies are immovable");
  for (const bool a : {true, false}) {
    if (!body(e, a).immovable) {
      worst = both(std::move(worst),
                   law_holds(e, Relation::equal, a ? "J_A Δw_A and r_A × m_A Δv_A" : "J_B Δw_B and r_B × m_B Δv_B",
                             law::AngularMomentum{a}));
    }
  }
  if (!body(e, true).immovable && !body(e, false).immovable) {
    worst = both(std::move(worst),
                 law_holds(e, Relation::equal, "angular momentum about the origin: what A gains and B loses",
                           law::TotalAngularMomentum{}));
  }
  return worst;
}

Verdict check_restitution(const Evidence& e) {
  if (!collides(e)) {
    return outside_domain("the contact is not colliding");
  }
  return law_holds(e, Relation::equal, "N·V⁺ and −ε N·V⁻", law::Restitution{});
}

Verdict check_non_penetration(const Evidence& e) {
  if (is_inert(e)) {
    return outside_domain("both bodies are immovable");
  }
  return law_holds(e, Relation::at_least, "N·V⁺ and 0", law::NonPenetration{});
}

Verdict check_push(const Evidence& e) {
  if (is_inert(e)) {
    return outside_domain("both bodies are immovable");
  }
  Verdict verdict = law_holds(e, Relation::at_least, "N·F and 0", law::Push{e.exact_case.reads_impulse_off_a()});
  // A residual over the outputs alone knows nothing of the inputs' rounding, which decides the sign of N·V⁻ there.
  if (verdict.status == Status::violated && e.exact_case.is_grazing(e.allowance())) {
    if (e.accuracy == nullptr) {
      return outside_domain("within rounding of a separating contact");
    }
    if (!e.accuracy->is_decided) {
      return beyond_range();
    }
    const auto& allowed = e.accuracy->allowed;
    if (std::all_of(allowed.begin(), allowed.end(), [](bool is_allowed) { return is_allowed; })) {
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
  if (are_surely_untouched(e, {0, 1, 2, 3})) {
    return {};
  }
  const oracles::Sensitivity& sensitivity = e.exact_case.sensitivity(e.model, e.allowance());
  Verdict worst;
  for (std::size_t k = 0; k < sensitivity.size(); ++k) {
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
  return law_holds(e, Relation::equal, "N × F and 0", law::FrictionlessDirection{e.exact_case.reads_impulse_off_a()});
}

Verdict check_reflection_plane(const Evidence& e) {
  if (is_inert(e)) {
    return outside_domain("both bodies are immovable");
  }
  return law_holds(e, Relation::equal, "N × V⁺ and N × V⁻", law::ReflectionPlane{});
}

Verdict check_energy(const Evidence& e) {
  if (is_inert(e)) {
    return outside_domain("both bodies are immovable");
  }
  if (e.closeness.shows_energy()) {
    count(oracles::Stage::closeness);
    return {};
  }
  return law_holds(e, Relation::at_most, "E⁺ − E⁻ and the work of the wall", law::Energy{});
}

Verdict check_collinear_spin(const Evidence& e) {
  if (!collides(e)) {
    return outside_domain("the contact is not colliding");
  }
  if (!e.exact_case.is_collinear()) {
    return outside_domain("a lever arm is not along the normal");
  }
  if (are_surely_untouched(e, {1, 3})) {
    return {};
  }
  const oracles::Sensitivity& sensitivity = e.exact_case.sensitivity(e.model, e.allowance());
  return both(vector_untouched(e, 1, sensitivity), vector_untouched(e, 3, sensitivity));
}

}  // namespace carom::properties
