// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <carom/properties/cases/family.hpp>

/// Cases with the choices that make them. A draw function asks its Stream questions (`StreamQuestion`), and a choice is
/// one answer.
namespace carom::properties {

/// `Family::generate`, or a function that calls it for several families.
using Draw = std::function<Case(Stream&)>;

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

/// Draws a case with the random words of `next`. Below `whole_size`, a smaller size gives more questions their simplest
/// answers. At size 0, all answers are simplest.
[[nodiscard]] ChosenCase chosen_case(const Draw& draw, const std::function<std::uint64_t()>& next, int size);

/// Makes the case of these choices. If a question's count differs from the recorded count, scales the answer. Questions
/// after the last choice get their simplest answers.
[[nodiscard]] ChosenCase replayed_case(const Draw& draw, const std::vector<Choice>& choices);

}  // namespace carom::properties
