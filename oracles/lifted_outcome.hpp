// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include <carom/oracles/enclosure.hpp>

namespace carom::oracles {

/// An outcome as it is judged: exactly, as enclosures, and rounded. For one thread.
class LiftedOutcome {
 public:
  /// Precondition: every number is finite.
  explicit LiftedOutcome(const ReportedOutcome& reported)
      : reported_(reported),
        enclosed_(map_outcome<Enclosure>(reported, [](long double x) { return Enclosure(x); })),
        rounded_(map_outcome<double>(reported, [](long double x) { return static_cast<double>(x); })) {}

  explicit LiftedOutcome(Outcome<Rational> exact)
      : enclosed_(map_outcome<Enclosure>(exact, [](const Rational& x) { return Enclosure(x); })),
        rounded_(map_outcome<double>(exact, [](const Rational& x) { return to_double(x); })),
        exact_(std::move(exact)) {}

  [[nodiscard]] const Outcome<Enclosure>& enclosed() const { return enclosed_; }
  [[nodiscard]] const Outcome<double>& rounded() const { return rounded_; }
  [[nodiscard]] const Outcome<Rational>& exact() const {
    if (!exact_) {
      exact_ = lift(*reported_);
    }
    return *exact_;
  }

 private:
  std::optional<ReportedOutcome> reported_;
  Outcome<Enclosure> enclosed_;
  Outcome<double> rounded_;
  mutable std::optional<Outcome<Rational>> exact_;
};

}  // namespace carom::oracles
