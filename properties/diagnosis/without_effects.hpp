// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties::diagnosis {

/// The case that the judge compares with the law, and the answer without the effects that the subject declares
/// (declared_effects.hpp), rounded to binary64. An invalid case stays as it is.
[[nodiscard]] ViolatedCase without_effects(const ViolatedCase& one, const Subject& subject);

}  // namespace carom::properties::diagnosis
