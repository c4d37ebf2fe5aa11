// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/oracles/exact/radical.hpp>
#include <carom/properties/invariants/invariant.hpp>

/// Numbers and collisions as a person reads them.
namespace carom::properties {

/// The shortest decimal that is this number and no other.
[[nodiscard]] std::string in_words(double number);
[[nodiscard]] std::string in_words(long double number);

/// p/q where that is short, else the nearest binary64 number behind "≈".
[[nodiscard]] std::string in_words(const oracles::Rational& number);
[[nodiscard]] std::string in_words(const oracles::Radical& number);

/// "(x, y, z)".
[[nodiscard]] std::string in_words(const std::vector<double>& numbers);
template <class S>
[[nodiscard]] std::string in_words(const Vector3<S>& vector) {
  return '(' + in_words(vector[0]) + ", " + in_words(vector[1]) + ", " + in_words(vector[2]) + ')';
}

/// Four lines: both bodies, the contact, the coefficients.
[[nodiscard]] std::string in_words(const Collision& collision, const std::string& indent);

/// One line a body.
[[nodiscard]] std::string in_words(const ReportedOutcome& outcome, const std::string& indent);

/// What was compared, both sides, and by how much they miss each other; no line end.
[[nodiscard]] std::string in_words(const Verdict& violated);

/// The text with every line but the first moved in.
[[nodiscard]] std::string indented(const std::string& text, const std::string& by);

/// The collision, the answer to it and the violated verdict on both, each on lines of its own.
[[nodiscard]] std::string violation_in_words(const Collision& collision, const Answer& answer, const Verdict& violated);

}  // namespace carom::properties
