// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <carom/properties/invariants/invariant_groups.hpp>

namespace carom::properties {

double Verdict::severity() const {
  if (status != Status::violated) {
    return 0;
  }
  return residual > 0 && allowed > 0 ? residual / allowed : std::numeric_limits<double>::infinity();
}

namespace {

double largest_compared(const Verdict& verdict) {
  double largest = 0;
  for (const std::vector<double>* side : {&verdict.left, &verdict.right}) {
    for (const double number : *side) {
      largest = std::max(largest, std::abs(number));
    }
  }
  return largest;
}

}  // namespace

double Verdict::relative_residual() const {
  const double largest = largest_compared(*this);
  return status == Status::violated && largest > 0 ? residual / largest : 0;
}

double seriousness(const Verdict& verdict, const Collision& collision) {
  if (verdict.status != Status::violated || !(verdict.residual > 0) || verdict.allowed > 0) {
    return verdict.severity();
  }
  double largest = largest_compared(verdict);
  for (const Body* body : {&collision.a, &collision.b}) {
    largest = std::max({largest, body->velocity.cwiseAbs().maxCoeff(), body->angular_velocity.cwiseAbs().maxCoeff()});
  }
  return verdict.residual / (largest > 0 ? largest : 1) / 0x1p-53;
}

bool Invariant::is_of_invalid() const {
  const auto* const answer = std::get_if<AboutAnswer>(&about);
  return answer != nullptr && !answer->to_valid;
}

std::vector<Law> Invariant::proved_laws() const {
  std::vector<Law> proved;
  if (!proof.theorems.empty()) {
    std::ranges::copy_if(laws, std::back_inserter(proved),
                         [&](Law law) { return proof.of == ProvedOf::every_impulse || determines_outcome(law); });
  }
  return proved;
}

bool Invariant::claimed_for(Law law) const { return std::find(laws.begin(), laws.end(), law) != laws.end(); }

std::span<const Invariant> all_invariants() {
  static const std::vector<Invariant> all = [] {
    std::vector<Invariant> joined;
    for (const auto group : {answer_invariants, outcome_invariants, matrix_invariants, collinear_spin_invariants,
                             relation_invariants, memory_invariants}) {
      std::ranges::move(group(), std::back_inserter(joined));
    }
    return joined;
  }();
  return all;
}

const Invariant* invariant_named(std::string_view name) {
  for (const Invariant& invariant : all_invariants()) {
    if (invariant.name == name) {
      return &invariant;
    }
  }
  return nullptr;
}

namespace {

/// Converts a finite outcome from the type Lifted.
template <class Lifted>
void lift_as(const Answer& answer, ExactAnswer& into) {
  if (const auto* outcome = std::get_if<ReportedOutcome>(&answer)) {
    const auto& lifted = into.emplace<oracles::LiftedOutcome>(static_cast<const Lifted&>(*outcome));
    if (!lifted.is_moderate() && !oracles::is_finite(*outcome)) {
      into = NotFinite{};
    }
  } else if (const auto* skipped = std::get_if<Skipped>(&answer)) {
    into = *skipped;
  } else if (const auto* refused = std::get_if<Refused>(&answer)) {
    into = *refused;
  } else {
    into = std::get<Failed>(answer);
  }
}

}  // namespace

ExactAnswer lift(const Answer& answer) {
  ExactAnswer lifted{NotFinite{}};
  lift_as<ReportedOutcome>(answer, lifted);
  return lifted;
}

void lift_without_matrix(const Answer& answer, ExactAnswer& into) { lift_as<Outcome<long double>>(answer, into); }

}  // namespace carom::properties
