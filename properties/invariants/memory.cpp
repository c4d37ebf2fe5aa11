// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <carom/properties/invariants/groups.hpp>

namespace carom::properties {
namespace {

bool same_bits(long double x, long double y) {
  return (x == y && std::signbit(x) == std::signbit(y)) || (std::isnan(x) && std::isnan(y));
}

Verdict differs(const char* what) { return {Status::violated, what, 0, 0, {}, {}}; }

Verdict check_memoryless(const Answer& first, const Answer& again) {
  if (first.index() != again.index()) {
    return differs("asked again, it is answered otherwise: an outcome, a refusal and a skip are not the same");
  }
  const auto* outcome = std::get_if<ReportedOutcome>(&first);
  if (outcome == nullptr) {
    return {};
  }
  const auto before = vectors(*outcome);
  const auto after = vectors(std::get<ReportedOutcome>(again));
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      if (!same_bits((*before[k])[i], (*after[k])[i])) {
        Verdict verdict = differs("asked again, it has other bits");
        for (int j = 0; j < 3; ++j) {
          verdict.left.push_back(static_cast<double>((*before[k])[j]));
          verdict.right.push_back(static_cast<double>((*after[k])[j]));
        }
        verdict.detail = std::string(name_of(k)) + ", asked first and asked again";
        verdict.residual = static_cast<double>(std::abs((*before[k])[i] - (*after[k])[i]));
        return verdict;
      }
    }
  }
  return {};
}

}  // namespace

std::vector<Invariant> memory_invariants() {
  return {Invariant{"memoryless",
                    "The same collision has the same bits whenever it is asked: later in a session, in another order, "
                    "after an invalid one, in a session of its own.",
                    R"(y_2(x) = y_1(x), \text{ bit for bit})",
                    "caches, warm starts, and what a refused request leaves behind", "collisions that are asked again",
                    every_model(), AboutSession{check_memoryless}}};
}

}  // namespace carom::properties
