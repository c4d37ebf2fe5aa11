// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <carom/properties/gate/gate_result.hpp>

#include "compare/field.hpp"

namespace carom::tool::merge {

/// What witness_record wrote. Throws FormatError, which names the place.
[[nodiscard]] properties::Witness witness_from(const compare::Field& record);

}  // namespace carom::tool::merge
