// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/gate/gate_result.hpp>

#include "compare/field.hpp"

namespace carom::tool::merge {

/// What witness_record wrote, answer_record, and verdict_record of a violation. They throw FormatError, which names the
/// place.
[[nodiscard]] properties::Witness witness_from(const compare::Field& record);
[[nodiscard]] Answer answer_from(const compare::Field& record);
[[nodiscard]] properties::Verdict verdict_from(const compare::Field& record);

}  // namespace carom::tool::merge
