// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <carom/properties/families/family.hpp>

/// Cases together with the choices that make them. A choice is an answer to a question that a Stream is asked. The same
/// draw function makes another case from other choices.
namespace carom::properties {

/// A draw function: `Family::generate`, or a function that calls it for several families.
using Draw = std::function<Case(Stream&)>;

/// A question of a draw function, and the answer.
struct Choice {
  StreamQuestion question;
  std::uint64_t answer;  // less than the question's count
};

struct ChosenCase {
  Case one;
  std::vector<Choice> choices;
};

/// From this size of RapidCheck on, all answers are equally likely and `Stream::plainly` is false, as in the gate.
inline constexpr int whole_size = 50;

/// Draws a case with the random words of `next`. Below `whole_size`, a smaller size makes more answers the simplest
/// ones. At size 0, all answers are the simplest ones.
[[nodiscard]] ChosenCase chosen_case(const Draw& draw, const std::function<std::uint64_t()>& next, int size);

/// The case that these choices make. If a question's count differs from the recorded count, the answer is scaled to the
/// new count. After the last choice, each answer is the simplest.
[[nodiscard]] ChosenCase replayed_case(const Draw& draw, const std::vector<Choice>& choices);

/// Draws a case of a random family of valid collisions, by the families' weights.
[[nodiscard]] Case case_of_any_family(Stream& stream);

}  // namespace carom::properties
