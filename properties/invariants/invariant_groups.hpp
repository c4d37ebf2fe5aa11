// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/invariants/invariant.hpp>

/// The catalogue, in groups. Each group has a file that holds an invariant's words next to its check.
namespace carom::properties {

[[nodiscard]] std::vector<Invariant> answer_invariants();
[[nodiscard]] std::vector<Invariant> outcome_invariants();
[[nodiscard]] std::vector<Invariant> matrix_invariants();
[[nodiscard]] std::vector<Invariant> collinear_spin_invariants();
[[nodiscard]] std::vector<Invariant> relation_invariants();
[[nodiscard]] std::vector<Invariant> memory_invariants();

/// The laws that an invariant may be claimed for.
[[nodiscard]] inline std::vector<Law> every_law() { return {all_laws.begin(), all_laws.end()}; }
[[nodiscard]] inline std::vector<Law> with_truth() { return {laws_with_truth.begin(), laws_with_truth.end()}; }

}  // namespace carom::properties
