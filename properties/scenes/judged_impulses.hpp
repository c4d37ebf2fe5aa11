// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <carom/oracles/judge/yardstick.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/scene/event.hpp>

namespace carom::properties {

struct BadImpulse {
  double time = 0;
  std::string_view invariant;
  Collision collision;
  ReportedOutcome outcome;
};

/// Judges the impulses of a scene as the gate judges a subject of the scene's law and precision. The states are stored
/// in binary64, so an impulse of a higher precision is judged as binary64.
class ImpulseJudge {
 public:
  /// Judges every `every`-th impulse; none if `every` is 0.
  ImpulseJudge(Law law, Precision precision, std::uint64_t every, const oracles::Limits& limits);

  void record(const scene::Event& event);

  [[nodiscard]] std::uint64_t impulses() const { return impulses_; }
  [[nodiscard]] std::uint64_t judged() const { return judged_; }
  [[nodiscard]] std::uint64_t violated() const { return violated_; }
  [[nodiscard]] double worst_backward_error() const { return worst_backward_error_; }
  /// For each invariant, the number of judged impulses for which the invariant holds.
  [[nodiscard]] const std::map<std::string_view, std::uint64_t>& times_held() const { return times_held_; }
  [[nodiscard]] const std::optional<BadImpulse>& first_bad() const { return first_bad_; }

 private:
  Subject subject_;
  Claim claim_;
  std::uint64_t every_;
  std::uint64_t impulses_ = 0;
  std::uint64_t judged_ = 0;
  std::uint64_t violated_ = 0;
  double worst_backward_error_ = 0;
  std::map<std::string_view, std::uint64_t> times_held_;
  std::optional<BadImpulse> first_bad_;
};

}  // namespace carom::properties
