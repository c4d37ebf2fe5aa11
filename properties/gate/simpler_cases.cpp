// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <bit>
#include <set>
#include <utility>

#include <carom/properties/gate/shrink.hpp>
#include <carom/properties/gate/simpler_cases.hpp>

namespace carom::properties {
namespace {

constexpr std::array<std::uint64_t, 8> fewer_bits{0, 1, 2, 3, 5, 8, 16, 32};

/// The largest multiple of 2^−bits that is at most this fraction, both in units of 2⁻⁵³.
std::uint64_t shortened(std::uint64_t fraction, std::uint64_t bits) {
  const std::uint64_t unit = fractions >> bits;
  return fraction / unit * unit;
}

/// Other answers to a question, roughly from the simplest on.
std::vector<std::uint64_t> other_answers(const Choice& choice) {
  const std::uint64_t count = choice.question.count;
  const std::uint64_t simplest = choice.question.simplest;
  std::vector<std::uint64_t> answers{simplest};
  constexpr std::uint64_t few = 8;
  if (count == fractions) {
    for (const std::uint64_t bits : fewer_bits) {
      answers.push_back(shortened(choice.answer, bits));
    }
    answers.push_back(fractions / 2);
  } else if (count <= few) {
    for (std::uint64_t answer = 0; answer < count; ++answer) {
      answers.push_back(answer);
    }
  } else if (choice.answer != simplest) {
    const bool is_above = choice.answer > simplest;
    const std::uint64_t distance = is_above ? choice.answer - simplest : simplest - choice.answer;
    const std::uint64_t room_above = count - 1 - simplest;
    for (const std::uint64_t closer : {std::uint64_t{1}, distance / 2, std::bit_floor(distance), distance - 1}) {
      answers.push_back(is_above ? simplest + closer : simplest - closer);
    }
    if (!is_above && distance <= room_above) {
      answers.push_back(simplest + distance);
    }
  }
  std::set<std::uint64_t> seen{choice.answer};
  std::erase_if(answers, [&](std::uint64_t answer) { return !seen.insert(answer).second; });
  return answers;
}

std::vector<Edit> edits_of(const std::vector<Choice>& choices) {
  const std::size_t count = choices.size();
  std::vector<Edit> edits;
  // The first choice may choose the family. Another family asks other questions, which the later choices do not fit. So
  // edits of every length remove some of the later choices.
  for (std::size_t length = 1; length <= count; ++length) {
    edits.push_back({Edit::Kind::answer, 0, length, choices[0].question.simplest});
  }
  for (const std::uint64_t bits : fewer_bits) {
    edits.push_back({Edit::Kind::shorten, 0, count, bits});
  }
  for (std::size_t length = count; length > 1; length /= 2) {
    for (std::size_t first = 0; first < count; first += length) {
      edits.push_back({Edit::Kind::simplify, first, std::min(first + length, count)});
    }
  }
  for (std::size_t place = 0; place < count; ++place) {
    for (const std::uint64_t answer : other_answers(choices[place])) {
      for (const std::size_t length : {1U, 2U, 3U}) {
        edits.push_back({Edit::Kind::answer, place, std::min(place + length, count), answer});
      }
    }
  }
  for (const std::size_t length : {16U, 8U, 4U, 3U, 2U, 1U}) {
    for (std::size_t first = 0; first + length <= count; ++first) {
      edits.push_back({Edit::Kind::remove, first, first + length});
    }
  }
  return edits;
}

std::vector<Choice> edited(std::vector<Choice> choices, const Edit& edit) {
  const auto begin = choices.begin() + static_cast<std::ptrdiff_t>(edit.first);
  const auto end = choices.begin() + static_cast<std::ptrdiff_t>(edit.last);
  switch (edit.kind) {
    case Edit::Kind::simplify:
      std::for_each(begin, end, [](Choice& choice) { choice.answer = choice.question.simplest; });
      break;
    case Edit::Kind::remove:
      choices.erase(begin, end);
      break;
    case Edit::Kind::answer:
      begin->answer = edit.value;
      choices.erase(begin + 1, end);
      break;
    case Edit::Kind::shorten:
      std::for_each(begin, end, [&](Choice& choice) {
        choice.answer = choice.question.count == fractions ? shortened(choice.answer, edit.value) : choice.answer;
      });
      break;
  }
  return choices;
}

}  // namespace

SimplerCases::SimplerCases(Draw draw, ChosenCase from, std::size_t first)
    : draw_(std::move(draw)),
      from_(std::move(from)),
      edits_(edits_of(from_.choices)),
      first_(first % edits_.size()),
      complexity_(complexity(from_.one.collision)) {}

std::optional<ChosenCase> SimplerCases::next() {
  while (tried_ < edits_.size()) {
    const Edit& edit = edits_[(first_ + tried_++) % edits_.size()];
    ChosenCase changed = replayed_case(draw_, edited(from_.choices, edit));
    if (complexity(changed.one.collision) < complexity_) {
      return changed;
    }
  }
  return std::nullopt;
}

}  // namespace carom::properties
