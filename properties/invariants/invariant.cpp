// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
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

/// The words of each ViolationKind, in its order.
constexpr std::array<std::string_view, 14> words_of_kinds{
    "",
    "the outcome contains infinities or NaN",
    "the subject refused a valid collision",
    "no answer",
    "the subject did not refuse an invalid collision",
    "the subject answered an invalid collision",
    "the subject refused the related collision",
    "the outcome of the related collision contains infinities or NaN",
    "the repeated request got another kind of answer",
    "only one of the two answers to the same request has a collision matrix",
    "the subject shows no C of this contact",
    "the shown C contains infinities or NaN",
    "the subject failed",
    "the subject threw"};

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

Verdict violation(ViolationKind kind, const std::string& more) {
  return {.status = Status::violated,
          .detail = std::string(words_of_kinds[static_cast<std::size_t>(kind)]) + more,
          .kind = kind};
}

ViolationKind kind_of_detail(std::string_view detail) {
  const auto found = std::find_if(words_of_kinds.begin() + 1, words_of_kinds.end(),
                                  [&](std::string_view words) { return detail.starts_with(words); });
  return static_cast<ViolationKind>(found == words_of_kinds.end() ? 0 : found - words_of_kinds.begin());
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

std::vector<std::string> names_of(const std::vector<const Invariant*>& invariants) {
  std::vector<std::string> names;
  for (const Invariant* invariant : invariants) {
    names.emplace_back(invariant->name);
  }
  return names;
}

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
