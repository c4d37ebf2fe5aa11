// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <carom/properties/families/family.hpp>

/// Cases together with the choices that make them. A case that other choices make is drawn by the same definition.
namespace carom::properties {

/// Draws a case: the definition of a family, or one that is made of families.
using Draw = std::function<Case(Stream&)>;

/// A question of the definition, and the answer to it.
struct Choice {
  StreamQuestion question;
  std::uint64_t answer;  // less than the question's count
};

struct ChosenCase {
  Case one;
  std::vector<Choice> choices;
};

/// From this size on, every answer is as likely as another, and nothing is plain: it is the gate's distribution.
inline constexpr int whole_size = 50;

/// Draws a case with random words. Below `whole_size` the smaller the size, the more answers are the simplest ones; at
/// size 0 all are.
[[nodiscard]] ChosenCase chosen_case(const Draw& draw, const std::function<std::uint64_t()>& next, int size);

/// The case that these choices make. If a question has another count than the one that was answered, the answer is
/// scaled to it. Beyond the last choice each answer is the simplest.
[[nodiscard]] ChosenCase replayed_case(const Draw& draw, const std::vector<Choice>& choices);

/// Draws one of all families of valid collisions, by their weights.
[[nodiscard]] Case case_of_any_family(Stream& stream);

}  // namespace carom::properties
