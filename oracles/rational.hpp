// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <CGAL/Gmpq.h>
#include <Eigen/Core>

#include <carom/collision/outcome.hpp>

namespace carom::oracles {

/// An exact rational number. Every finite floating-point number is one.
using Rational = CGAL::Gmpq;

/// The number itself, without rounding. Precondition: finite (CGAL ends the process on any other).
[[nodiscard]] Rational lift(long double number);

/// Precondition: every number of the collision is finite.
[[nodiscard]] BasicCollision<Rational> lift(const Collision& collision);

/// Precondition: every number of the outcome is finite.
[[nodiscard]] Outcome<Rational> lift(const ReportedOutcome& outcome);

/// Within one unit in the last place: for scales and for print.
[[nodiscard]] double to_double(const Rational& number);

/// The binary64 number nearest to it, ties to even.
[[nodiscard]] double nearest_double(const Rational& number);

/// −1, 0 or 1.
[[nodiscard]] inline int sign_of(const Rational& number) { return number < 0 ? -1 : (number > 0 ? 1 : 0); }

/// "p/q" in lowest terms, "p" where q = 1.
[[nodiscard]] std::string to_text(const Rational& number);

[[nodiscard]] bool is_finite(const ReportedOutcome& outcome);

}  // namespace carom::oracles
