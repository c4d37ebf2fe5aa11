// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <optional>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/collision/precision.hpp>

namespace carom::oracles {

/// The limit of the backward error [ulps]. By measurement, accurate solvers stay below this limit on every physically
/// possible body.
inline constexpr double default_limit_ulps = 32;

/// The largest allowance for which lower bounds of sensitivities and scales may decide. Up to this limit, the allowance
/// times a sensitivity or scale of a moderate collision (moderate.hpp) is finite.
inline constexpr double largest_allowance_for_bounds = 0x1p+64;

/// The limits that a user sets. They apply to answers of any precision.
struct Limits {
  double limit_ulps = default_limit_ulps;  // of the backward error [ulps]
  std::optional<int> digits = {};          // if set, decides instead of ulps
  bool filtered = true;                    // numbers with error bounds may decide before rationals
};

/// The amount of rounding that is allowed (docs/reference/yardstick.md). The residual of an equation g passes if it is
/// at most `allowance` times the scale Σ_q ‖∂g/∂q‖ ‖q‖ + Σ_k ‖∂g/∂ŷ_k‖ (‖ŷ_k‖ + ‖y_k⁻‖). q are the quantities, ŷ_k the
/// outputs, and y_k⁻ the vectors before the impulse. In binary32 the scale also contains the loss of the outputs by
/// underflow.
class Yardstick {
 public:
  /// For answers that are computed in a precision. Every judge of a precision takes its yardstick from here, so all
  /// give the same verdicts.
  [[nodiscard]] static Yardstick of(Precision precision, const Limits& limits = {}) {
    return {limits, carom::unit_roundoff(precision), least_size_known_to_a_roundoff(precision)};
  }

  /// For answers in exact arithmetic, which is allowed no rounding.
  [[nodiscard]] static Yardstick of_exact_arithmetic(const Limits& limits = {}) { return {limits, 0, 0}; }

  /// This yardstick, by which rationals alone decide if `filtered` is false.
  [[nodiscard]] Yardstick with_filters(bool filtered) const {
    Yardstick changed = *this;
    changed.limits_.filtered = filtered;
    return changed;
  }

  [[nodiscard]] const Limits& limits() const { return limits_; }
  [[nodiscard]] const std::optional<int>& digits() const { return limits_.digits; }
  [[nodiscard]] bool filtered() const { return limits_.filtered; }

  /// u of the precision; 0 for exact arithmetic.
  [[nodiscard]] double unit_roundoff() const { return unit_roundoff_; }
  /// least_size_known_to_a_roundoff of the precision; 0 for exact arithmetic.
  [[nodiscard]] double least_size() const { return least_size_; }

  /// Whether lower bounds of the allowed error may decide.
  [[nodiscard]] bool uses_bounds() const {
    return filtered() && allowance() > 0 && allowance() <= largest_allowance_for_bounds;
  }

  /// How much the inputs may be rounded, also if digits decide.
  [[nodiscard]] double rounding() const { return limits_.limit_ulps * unit_roundoff_; }

  [[nodiscard]] double allowance() const { return digits() ? std::pow(10.0, -*digits()) : rounding(); }

  /// The allowance times a scale. No value if the product leaves the range in which binary64 has all its digits.
  [[nodiscard]] std::optional<double> allowed(double scale) const {
    const double product = allowance() * scale;
    const bool is_zero = product == 0 && (scale == 0 || allowance() == 0);
    return is_zero || std::isnormal(product) ? std::optional<double>(product) : std::nullopt;
  }

 private:
  Yardstick(const Limits& limits, double unit_roundoff, double least_size)
      : limits_(limits), unit_roundoff_(unit_roundoff), least_size_(least_size) {}

  Limits limits_;
  double unit_roundoff_;
  double least_size_;
};

/// With `Yardstick::digits`: the error of each vector that passes as rounding. A relative error permits nothing where
/// the exact value is 0, so the noise is `limit_ulps` ulps of the largest speed V in the contact. V is the largest of
/// ‖v⁻‖, ‖w⁻‖ ‖r‖ and ‖w⁻‖ ρ of both bodies, with ρ = √(least moment / m). The noise of w is that of V/ρ, and 0 if the
/// body is immovable. All is 0 without digits. Precondition: the collision is valid.
[[nodiscard]] PerVector<double> permitted_noise(const Collision& collision, const Yardstick& yardstick);

/// Adds `permitted_noise` divided by the allowance to sizes that the allowance multiplies.
void add_permitted_noise(const Collision& collision, const Yardstick& yardstick, PerVector<double>& sizes);

}  // namespace carom::oracles
