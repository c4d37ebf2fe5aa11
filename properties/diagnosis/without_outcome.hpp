// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <vector>

#include <carom/properties/diagnosis/fault.hpp>

namespace carom::properties::diagnosis {

struct FaultOfKind {
  AnswerKind kind;
  Fault fault;
};

/// The faults of answers to valid collisions that are not outcomes of finite numbers, one for each kind of answer.
[[nodiscard]] std::vector<FaultOfKind> faults_without_outcome(std::span<const ViolatedCase> examples);

}  // namespace carom::properties::diagnosis
