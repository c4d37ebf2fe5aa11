// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <optional>

#include <carom/collision/precision.hpp>

namespace carom::oracles {

/// The limit that sound outcomes were found to stay below on every physically possible body, in ulps.
inline constexpr double default_limit_ulps = 32;

/// Where more is allowed, lower bounds of what is allowed decide nothing: up to here what is allowed of a moderate
/// collision (moderate.hpp) is a finite number, as it has to be for a pass.
inline constexpr double largest_allowance_for_bounds = 0x1p+64;

/// How much rounding is allowed. A residual passes up to `allowance` times its scale, the sum of ‖∂g/∂q‖ ‖q‖ over the
/// quantities (quantities.hpp) and of ‖∂g/∂ŷ‖ (‖ŷ‖ + ‖y⁻‖) over the outputs: it then vanishes for inputs and outputs
/// that differ by so much. In binary32 the outputs are also allowed the loss by underflow.
struct Yardstick {
  double unit_roundoff = 0;  // u of the subject's precision; 0 judges exact arithmetic, with nothing allowed
  double least_size = 0;     // least_size_known_to_a_roundoff of that precision
  double limit_ulps = default_limit_ulps;
  std::optional<int> digits;  // decides in place of ulps where given

  /// Whether enclosures may decide what they can. The verdicts are the same without, only slower.
  bool filtered = true;

  /// Whether lower bounds of what is allowed may decide.
  [[nodiscard]] bool uses_bounds() const {
    return filtered && allowance() > 0 && allowance() <= largest_allowance_for_bounds;
  }

  [[nodiscard]] double allowance() const { return digits ? std::pow(10.0, -*digits) : limit_ulps * unit_roundoff; }

  /// The allowance times a scale; none where that leaves the range in which binary64 has all its digits: nothing can
  /// then be decided by it.
  [[nodiscard]] std::optional<double> allowed(double scale) const {
    const double product = allowance() * scale;
    const bool is_zero = product == 0 && (scale == 0 || allowance() == 0);
    return is_zero || std::isnormal(product) ? std::optional<double>(product) : std::nullopt;
  }
};

}  // namespace carom::oracles
