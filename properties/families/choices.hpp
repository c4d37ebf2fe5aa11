// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <carom/properties/families/family.hpp>

/// Cases together with the choices that make them. The same definition draws another case from other choices.
namespace carom::properties {

/// Draws a case: the definition of a family, or a definition composed of families.
using Draw = std::function<Case(Stream&)>;

/// A question of the definition, and its answer.
struct Choice {
  StreamQuestion question;
  std::uint64_t answer;  // less than the question's count
};

struct ChosenCase {
  Case one;
  std::vector<Choice> choices;
};

/// From this size on, all answers are equally likely and no number is plain, as in the gate's distribution.
inline constexpr int whole_size = 50;

/// Draws a case with random words. Below `whole_size`, a smaller size makes more answers the simplest ones. At size 0,
/// all are the simplest.
[[nodiscard]] ChosenCase chosen_case(const Draw& draw, const std::function<std::uint64_t()>& next, int size);

/// The case that these choices make. If a question's count differs from the recorded one, the answer is scaled to it.
/// After the last choice, each answer is the simplest.
[[nodiscard]] ChosenCase replayed_case(const Draw& draw, const std::vector<Choice>& choices);

/// Draws a case of a random family of valid collisions, by the families' weights.
[[nodiscard]] Case case_of_any_family(Stream& stream);

}  // namespace carom::properties
