// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/exact/radical.hpp>
#include <carom/oracles/exact/rational.hpp>

namespace carom::oracles {

/// The sign of a number: −1, 0 or 1. No value if the bound of an enclosure does not decide it.
[[nodiscard]] inline std::optional<int> certain_sign(const Enclosure& x) { return x.sign(); }
[[nodiscard]] inline std::optional<int> certain_sign(const Rational& x) { return sign_of(x); }
[[nodiscard]] inline std::optional<int> certain_sign(const Radical& x) { return sign_of(x); }

}  // namespace carom::oracles
