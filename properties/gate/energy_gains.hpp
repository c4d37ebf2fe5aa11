// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>

#include <carom/properties/gate/trial.hpp>

namespace carom::properties {

/// An answer that gains kinetic energy beyond the work of a driven wall, and by more than permitted rounding.
struct EnergyGain {
  double joules = 0;
  double share = 0;  // of the kinetic energy before the impulse, in the frame of the wall's contact point, if any
  std::uint64_t index = 0;         // number of the case in its family
  const Family* family = nullptr;  // set by SubjectResult::energy
};

/// The energy that a subject's answers to colliding contacts gain.
struct EnergyGains {
  std::uint64_t colliding = 0;  // judged colliding cases that were answered by an outcome
  std::uint64_t gaining = 0;    // those that gain energy
  std::uint64_t by_law = 0;     // gaining cases in which an answer of the law gains energy, too
  std::optional<EnergyGain> greatest = {};
  std::optional<EnergyGain> greatest_share = {};

  [[nodiscard]] bool empty() const { return colliding == 0; }
  EnergyGains& operator+=(const EnergyGains& other);
};

/// The gain of one answer. `judgement` is that of the answer. Empty if the case is not judged, if it does not collide,
/// or if the answer is no finite outcome.
[[nodiscard]] EnergyGains energy_gains_of(std::uint64_t index, const JudgedCase& judged_case, const Claim& claim,
                                          const Answer& answer, const Judgement& judgement);

}  // namespace carom::properties
