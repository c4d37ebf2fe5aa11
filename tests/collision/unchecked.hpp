// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::unit {

/// How often a build that is not checked evaluates a condition that it states, and a value.
[[nodiscard]] int evaluations_of_an_unchecked_precondition();

}  // namespace carom::unit
