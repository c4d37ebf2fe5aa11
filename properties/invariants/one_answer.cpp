// SPDX-License-Identifier: BSL-1.0
#include <carom/collision/validate.hpp>
#include <carom/properties/invariants/invariant_groups.hpp>

namespace carom::properties {
namespace {

Verdict check_finite(const Collision& /*collision*/, const ExactAnswer& answer, Law /*law*/) {
  if (std::holds_alternative<NotFinite>(answer)) {
    return violation(ViolationKind::not_finite);
  }
  if (const auto* refused = std::get_if<Refused>(&answer)) {
    return violation(ViolationKind::refused, ": " + refused->why);
  }
  if (const auto* failed = std::get_if<Failed>(&answer)) {
    return violation(ViolationKind::no_answer, ": the subject " + failed->why);
  }
  return {};
}

/// Whether a collision is invalid only because of fields that the law does not read.
bool is_invalid_by_unread_fields(const Collision& collision, Law law) {
  Collision without = collision;
  if (law != Law::rough && law != Law::coulomb) {
    without.friction = 0;
  }
  if (law != Law::rough) {
    without.tangential_restitution = 0;
  }
  return validate(without).empty();
}

Verdict check_invalid_refused(const Collision& collision, const ExactAnswer& answer, Law law) {
  if (std::holds_alternative<Refused>(answer)) {
    return {};
  }
  if (const auto* failed = std::get_if<Failed>(&answer)) {
    return violation(ViolationKind::failed_on_invalid, ": it " + failed->why);
  }
  if (is_invalid_by_unread_fields(collision, law)) {
    return {.status = Status::skipped, .detail = "the law does not use the invalid field"};
  }
  return violation(ViolationKind::answered_invalid);
}

}  // namespace

std::vector<Invariant> answer_invariants() {
  return {Invariant{"finite", "A subject answers each valid collision with finite numbers.",
                    R"(x \text{ valid} \Rightarrow y(x) \in \mathbb{R}^{12})",
                    "protocol; failure cases 12, 25, 28 to 30, 34", "valid collisions", every_law(),
                    AboutAnswer{true, check_finite}, Proof{}, 2},
          Invariant{"invalid_refused", "A subject refuses each invalid collision.",
                    R"(x \text{ invalid} \Rightarrow \text{no } y(x))", "protocol; failure cases 12, 22, 28",
                    "invalid collisions", every_law(), AboutAnswer{false, check_invalid_refused}, Proof{}, 1}};
}

}  // namespace carom::properties
