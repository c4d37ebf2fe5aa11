// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/properties/cases/choices.hpp>

namespace carom::properties {
namespace {

template <class Answer>
ChosenCase noted(const Draw& draw, Answer answer) {
  ChosenCase chosen;
  Stream stream([&](const StreamQuestion& question) {
    chosen.choices.push_back({question, answer(question)});
    return chosen.choices.back().answer;
  });
  chosen.one = draw(stream);
  chosen.one.adjusted = stream.adjusted();
  return chosen;
}

std::uint64_t scaled(const Choice& choice, const StreamQuestion& question) {
  if (choice.question.count == question.count) {
    return choice.answer;
  }
  if (choice.answer == choice.question.simplest) {
    return question.simplest;
  }
  const long double share = static_cast<long double>(choice.answer) / static_cast<long double>(choice.question.count);
  return std::min(static_cast<std::uint64_t>(share * static_cast<long double>(question.count)), question.count - 1);
}

}  // namespace

ChosenCase chosen_case(const Draw& draw, const std::function<std::uint64_t()>& next, int size) {
  const auto is_free = [&] { return size >= whole_size || static_cast<int>(next() % whole_size) < size; };
  return noted(draw, [&](const StreamQuestion& question) {
    const std::uint64_t free = question.is_of_plainness ? 1 - question.simplest : next() % question.count;
    return is_free() ? free : question.simplest;
  });
}

ChosenCase replayed_case(const Draw& draw, const std::vector<Choice>& choices) {
  std::size_t place = 0;
  return noted(draw, [&](const StreamQuestion& question) {
    return place < choices.size() ? scaled(choices[place++], question) : question.simplest;
  });
}

}  // namespace carom::properties
