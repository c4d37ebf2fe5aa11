// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::unit {

/// How often a build without checks evaluates the condition of a precondition.
[[nodiscard]] int evaluations_of_an_unchecked_precondition();

}  // namespace carom::unit
