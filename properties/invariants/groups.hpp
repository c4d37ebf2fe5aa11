// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/invariants/invariant.hpp>

/// The catalogue by the files that define it: an invariant's words stand beside what it checks.
namespace carom::properties {

[[nodiscard]] std::vector<Invariant> answer_invariants();
[[nodiscard]] std::vector<Invariant> outcome_invariants();
[[nodiscard]] std::vector<Invariant> matrix_invariants();
[[nodiscard]] std::vector<Invariant> collinear_spin_invariants();
[[nodiscard]] std::vector<Invariant> relation_invariants();
[[nodiscard]] std::vector<Invariant> memory_invariants();

/// What an invariant may be claimed for.
[[nodiscard]] inline std::vector<Model> every_model() { return {all_models.begin(), all_models.end()}; }
[[nodiscard]] inline std::vector<Model> with_truth() { return {models_with_truth.begin(), models_with_truth.end()}; }

}  // namespace carom::properties
