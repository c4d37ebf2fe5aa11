// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/oracles/exact/radical.hpp>
#include <carom/oracles/laws/judge_error.hpp>
#include <carom/properties/invariants/invariant.hpp>

namespace carom::properties {

/// The shortest decimal that identifies this number. A long double that is not a binary64 number gets 21 digits.
[[nodiscard]] std::string in_words(double number);
[[nodiscard]] std::string in_words(long double number);

/// The exact text if it is at most 24 bytes long. Otherwise "≈" and the nearest binary64 number.
[[nodiscard]] std::string in_words(const oracles::Rational& number);
[[nodiscard]] std::string in_words(const oracles::Radical& number);

/// "(x, y, z)". A single number has no parentheses.
[[nodiscard]] std::string in_words(const std::vector<double>& numbers);
template <class S>
[[nodiscard]] std::string in_words(const Vector3<S>& vector) {
  return '(' + in_words(vector[0]) + ", " + in_words(vector[1]) + ", " + in_words(vector[2]) + ')';
}

/// Three lines, for A, B and the contact. A fourth line gives the friction and the tangential restitution if one of
/// them is not zero. `indent` begins each line.
[[nodiscard]] std::string in_words(const Collision& collision, const std::string& indent);

/// One line for each body, and one for the collision matrix if there is one.
[[nodiscard]] std::string in_words(const ReportedOutcome& outcome, const std::string& indent);

/// The comparison, its two sides, their distance and the permitted residual, without a line end.
[[nodiscard]] std::string in_words(const Verdict& violated);

/// The fault, the collision in words, and the collision as JSON, each on its own lines.
[[nodiscard]] std::string in_words(const oracles::JudgeError& error);

/// Runs `work`, on which no verdict depends. Returns why it failed; empty if it did not.
[[nodiscard]] std::string why_failed(const std::function<void()>& work);

/// The text, with `by` before each line except the first.
[[nodiscard]] std::string indented(const std::string& text, const std::string& by);

/// The text with lines of about `width` bytes: longer lines end at commas.
[[nodiscard]] std::string folded(const std::string& text, std::size_t width);

/// The collision, the answer and the violated verdict, each on its own lines. If the answer is a failure after a
/// request, the folded request stands for the collision.
[[nodiscard]] std::string violation_in_words(const Collision& collision, const Answer& answer, const Verdict& violated);

}  // namespace carom::properties
