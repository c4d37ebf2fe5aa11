// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <carom/properties/families/choices.hpp>

namespace carom::properties {

/// A change of the choices from `first` to before `last`. If the first gets another answer, the others go: they may
/// have been asked on account of it.
struct Edit {
  enum class Kind { simplify, remove, answer, shorten } kind;
  std::size_t first;
  std::size_t last;
  std::uint64_t value = 0;  // the answer; or to so many bits the fractions are shortened
};

/// The simpler cases that the same definition draws, the boldest changes of the choices first. Each is strictly simpler
/// than the case by `complexity`, so that shrinking ends, in small dyadic numbers. One after the other is worked out
/// when it is asked for.
class SimplerCases {
 public:
  /// `first`: the change to begin with; those before it come last.
  SimplerCases(Draw draw, ChosenCase from, std::size_t first = 0);

  /// Nothing if there are no more.
  [[nodiscard]] std::optional<ChosenCase> next();

  /// The place of the change that was tried last.
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
