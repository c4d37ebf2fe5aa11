// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <utility>

#include <carom/oracles/approximation.hpp>
#include <carom/oracles/enclosure.hpp>
#include <carom/oracles/moderate.hpp>

namespace carom::oracles {

/// An outcome as it is judged: exactly, as approximations, as enclosures, and rounded. For one thread.
class LiftedOutcome {
 public:
  /// Precondition: every number is finite.
  explicit LiftedOutcome(const ReportedOutcome& reported)
      : reported_(reported),
        rounded_(map_outcome<double>(reported, [](long double x) { return static_cast<double>(x); })) {
    find_size();
  }

  explicit LiftedOutcome(Outcome<Rational> exact)
      : rounded_(map_outcome<double>(exact, [](const Rational& x) { return to_double(x); })),
        enclosed_(map_outcome<Enclosure>(exact, [](const Rational& x) { return Enclosure(x); })),
        exact_(std::move(exact)) {
    find_size();
  }

  /// As the subject reported it; nullptr where it was computed in ℚ.
  [[nodiscard]] const ReportedOutcome* reported() const { return reported_ ? &*reported_ : nullptr; }

  /// Whether it was reported, and holds no number that is out of the ordinary (`is_moderate`): its products then stay
  /// in the range of numbers.
  [[nodiscard]] bool is_moderate() const { return is_moderate_; }

  /// Precondition: reported.
  [[nodiscard]] Outcome<Approximation> approximate() const {
    return map_outcome<Approximation>(*reported_, [](long double x) { return Approximation(x); });
  }

  [[nodiscard]] const Outcome<Enclosure>& enclosed() const {
    if (!enclosed_) {
      enclosed_ = map_outcome<Enclosure>(*reported_, [](long double x) { return Enclosure(x); });
    }
    return *enclosed_;
  }
  [[nodiscard]] const Outcome<double>& rounded() const { return rounded_; }
  [[nodiscard]] const Outcome<Rational>& exact() const {
    if (!exact_) {
      exact_ = lift(*reported_);
    }
    return *exact_;
  }

  /// ‖ŷ_k‖, but for a few roundings, of a moderate outcome.
  [[nodiscard]] std::array<double, 4> norms() const {
    const auto parts = vectors(rounded_);
    return {parts[0]->norm(), parts[1]->norm(), parts[2]->norm(), parts[3]->norm()};
  }

 private:
  void find_size() {
    is_moderate_ = reported_.has_value();
    for (const Vector3<double>* part : vectors(std::as_const(rounded_))) {
      is_moderate_ = is_moderate_ && part->squaredNorm() <= largest_moderate * largest_moderate;
    }
  }

  std::optional<ReportedOutcome> reported_;
  Outcome<double> rounded_;
  bool is_moderate_ = false;
  mutable std::optional<Outcome<Enclosure>> enclosed_;
  mutable std::optional<Outcome<Rational>> exact_;
};

}  // namespace carom::oracles
