// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/invariants/invariant.hpp>

/// The catalogue, in groups. Each group has a source file with the words and checks of its invariants.
namespace carom::properties {

[[nodiscard]] std::vector<Invariant> answer_invariants();
[[nodiscard]] std::vector<Invariant> outcome_invariants();
[[nodiscard]] std::vector<Invariant> matrix_invariants();
[[nodiscard]] std::vector<Invariant> collinear_spin_invariants();
[[nodiscard]] std::vector<Invariant> relation_invariants();
[[nodiscard]] std::vector<Invariant> memory_invariants();

/// Values for `Invariant::laws`: every law, or the laws with a truth.
[[nodiscard]] inline std::vector<Law> every_law() { return {all_laws.begin(), all_laws.end()}; }
[[nodiscard]] inline std::vector<Law> with_truth() { return {laws_with_truth.begin(), laws_with_truth.end()}; }

}  // namespace carom::properties
