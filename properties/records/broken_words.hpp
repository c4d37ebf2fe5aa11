// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/outcome.hpp>
#include <carom/oracles/laws/equations.hpp>

namespace carom::properties::records {

/// The fault of an outcome that does not satisfy the equation, with the two sides as numbers.
[[nodiscard]] std::string broken_words(const oracles::Equation& equation, const Collision& collision,
                                       const Outcome<double>& after);

/// The axis of the component that differs most, as "x", "y" or "z".
[[nodiscard]] const char* worst_axis(const Vector3<double>& difference);

}  // namespace carom::properties::records
