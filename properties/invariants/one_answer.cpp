// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <optional>
#include <span>

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

namespace {

bool is_same(long double x, long double y, Sameness sameness) {
  const bool is_same_number = x == y || (std::isnan(x) && std::isnan(y));
  const bool is_zero_of_other_sign = x == 0 && std::signbit(x) != std::signbit(y);
  return is_same_number && (sameness == Sameness::of_numbers || !is_zero_of_other_sign);
}

/// A violation if the numbers at this place of the two answers differ; otherwise no value.
std::optional<Verdict> difference(std::string_view place, std::span<const long double> first,
                                  std::span<const long double> again, Sameness sameness) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (!is_same(first[i], again[i], sameness)) {
      Verdict verdict{.status = Status::violated, .detail = std::string(place) + ", first answer and repeated answer"};
      for (std::size_t j = 0; j < first.size(); ++j) {
        verdict.left.push_back(static_cast<double>(first[j]));
        verdict.right.push_back(static_cast<double>(again[j]));
      }
      verdict.residual = static_cast<double>(std::abs(first[i] - again[i]));
      return verdict;
    }
  }
  return std::nullopt;
}

template <class Numbers>
std::span<const long double> numbers_of(const Numbers& numbers) {
  return {numbers.data(), static_cast<std::size_t>(numbers.size())};
}

Verdict check_memoryless(const Answer& first, const Answer& again, Sameness sameness) {
  if (first.index() != again.index()) {
    return violation(ViolationKind::another_kind_of_answer, ": an outcome, a refusal and a skip differ");
  }
  const auto* before = std::get_if<ReportedOutcome>(&first);
  if (before == nullptr) {
    return {};
  }
  const auto& after = std::get<ReportedOutcome>(again);
  for (const OutcomeVector k : all_outcome_vectors) {
    if (const auto differing =
            difference(name_of(k), numbers_of(*vectors(*before)[k]), numbers_of(*vectors(after)[k]), sameness)) {
      return *differing;
    }
  }
  if (before->collision_matrix.has_value() != after.collision_matrix.has_value()) {
    return violation(ViolationKind::matrix_in_one_answer);
  }
  if (before->collision_matrix) {
    const auto differing =
        difference("C", numbers_of(*before->collision_matrix), numbers_of(*after.collision_matrix), sameness);
    return differing.value_or(Verdict{});
  }
  return {};
}

}  // namespace

std::vector<Invariant> memory_invariants() {
  return {Invariant{"memoryless",
                    "The same collision always gets the same answer: later in a session, in another order, after an "
                    "invalid collision, and in a separate session. The answers of a program are equal as numbers, and "
                    "all other answers are equal bit for bit.",
                    R"(y_2(x) = y_1(x))", "caches, warm starts, and state that a refused request leaves behind",
                    "collisions that the gate asks a second time", every_law(), AboutSession{check_memoryless}, Proof{},
                    3}};
}

}  // namespace carom::properties
