// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <span>

#include <carom/oracles/exact/radical.hpp>
#include <carom/oracles/numbers/components.hpp>
#include <carom/oracles/numbers/enclosure.hpp>
#include <carom/oracles/numbers/norm.hpp>

namespace carom::oracles {

/// Whether ‖v‖ ≤ bound. No value if error bounds of the components do not decide it. Precondition: the bound is finite.
[[nodiscard]] bool norm_at_most(std::span<const Rational> vector, double bound);
[[nodiscard]] bool norm_at_most(std::span<const Radical> vector, double bound);
[[nodiscard]] std::optional<bool> norm_at_most(std::span<const Enclosure> vector, double bound);

/// Rounded for print.
[[nodiscard]] inline double rounded(const Rational& number) { return to_double(number); }
[[nodiscard]] inline double rounded(const Radical& number) { return to_double(number); }
[[nodiscard]] inline double rounded(const Enclosure& number) { return number.middle(); }

/// ‖v‖, rounded.
template <class T>
[[nodiscard]] double norm(const Components<T>& vector) {
  return root_of_squares(vector.size(), [&](std::size_t i) { return rounded(vector[i]); });
}

}  // namespace carom::oracles
