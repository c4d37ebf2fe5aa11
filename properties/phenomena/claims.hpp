// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <carom/properties/phenomena/measure.hpp>

/// Claims that an engine makes: "bounce within 5% at 1/60 s".
namespace carom::properties {

/// A longer step has no whole step in a fall or a slip. A shorter one would take minutes for a run.
inline constexpr double greatest_step = 0.1;  // [s]
inline constexpr double least_step = 1e-5;    // [s]

/// The step of "1/60" or "0.01"; no value if the text is no number from least_step to greatest_step.
[[nodiscard]] std::optional<double> step_from(const std::string& text);

/// Each error of the phenomenon is at most `within` at this step, at every phase.
struct TimeClaim {
  std::string phenomenon;
  double within = 0;  // a ratio > 0
  double step = 0;    // h, from least_step to greatest_step [s]
};

/// Throws std::invalid_argument if the text is no claim, or if it names no phenomenon.
[[nodiscard]] TimeClaim time_claim_from(std::string_view text);

struct ClaimVerdict {
  bool is_kept = false;
  double greatest = 0;  // of the relative errors at the step
  std::string why;      // it is not kept: one line
};

/// Precondition: the measurement is of the claim's phenomenon.
[[nodiscard]] ClaimVerdict verdict_of(const TimeClaim& claim, const Measurement& measurement);

}  // namespace carom::properties
