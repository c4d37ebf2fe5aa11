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

/// The models that an invariant may be claimed for.
[[nodiscard]] inline std::vector<Model> every_model() { return {all_models.begin(), all_models.end()}; }
[[nodiscard]] inline std::vector<Model> with_truth() { return {models_with_truth.begin(), models_with_truth.end()}; }

}  // namespace carom::properties
