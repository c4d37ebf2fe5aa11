// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <carom/properties/families/choices.hpp>

namespace carom::properties {

/// A change of the choices (families/choices.hpp) from `first` up to but not including `last`. The kind `answer`
/// changes the first answer and removes the other choices, because the old answer may have led to their questions.
struct Edit {
  enum class Kind { simplify, remove, answer, shorten } kind;
  std::size_t first;
  std::size_t last;
  std::uint64_t value = 0;  // the answer, or the number of bits to which fractions are shortened
};

/// The simpler cases that `draw` makes, the boldest changes of the choices first. Each has a smaller `complexity` than
/// `from`, so shrinking ends, with numbers of few binary digits. Each is computed only when it is requested.
class SimplerCases {
 public:
  /// `first` is the number of the change to begin with. The changes before it come last.
  SimplerCases(Draw draw, ChosenCase from, std::size_t first = 0);

  /// The next simpler case; none if there are no more.
  [[nodiscard]] std::optional<ChosenCase> next();

  /// The number of the change that was tried last.
  [[nodiscard]] std::size_t place() const { return (first_ + tried_ - 1) % edits_.size(); }

 private:
  Draw draw_;
  ChosenCase from_;
  std::vector<Edit> edits_;
  std::size_t first_;
  std::size_t tried_ = 0;
  long complexity_;
};

}  // namespace carom::properties
