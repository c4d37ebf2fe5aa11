// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>

#include <carom/properties/phenomena/measure.hpp>

/// Claims that an engine makes: "bounce within 5% at 1/60 s".
namespace carom::properties {

/// Each error of the phenomenon is at most `within` at this step, at every phase.
struct TimeClaim {
  std::string phenomenon;
  double within = 0;  // a ratio > 0
  double step = 0;    // h > 0 [s]
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
