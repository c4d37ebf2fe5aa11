// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/properties/cases/choices.hpp>

namespace carom::properties {

/// A change of the choices from `first` to `last` − 1. The kind `answer` changes the first answer and removes the other
/// choices, because the old answer may have led to their questions.
struct Edit {
  enum class Kind { simplify, remove, answer, shorten } kind;
  std::size_t first;
  std::size_t last;
  std::uint64_t value = 0;  // the answer, or the number of bits of shortened fractions
};

/// The simpler cases that `draw` makes, from the boldest change of the choices on. Each has a smaller `complexity` than
/// `from`, so shrinking ends. A case is computed when it is requested.
class SimplerCases {
 public:
  /// Begins with the change of number `first`. The changes before it come last.
  SimplerCases(Draw draw, ChosenCase from, std::size_t first = 0);

  /// The next simpler case, if any.
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

/// Simpler collisions close to this one, from the boldest change on: a body becomes immovable, a vector zero, a number
/// rounded to few bits. Then each is put into the kinds, such as the lever arm of a sphere along another normal. Each
/// collision is valid and has a smaller `complexity`, so shrinking ends. Precondition: the collision is valid.
[[nodiscard]] std::vector<Collision> simpler(const Collision& collision, const Kinds& kinds = {});

/// How hard a collision is to read: the bits of its numbers, and the distance of their exponents from 0.
[[nodiscard]] long complexity(const Collision& collision);

/// The simplest failing collision found. Ends if no collision of `simpler` fails, or after `most_calls` calls of
/// `still_fails`. Precondition: the collision is valid.
[[nodiscard]] Collision shrink(Collision collision, const std::function<bool(const Collision&)>& still_fails,
                               std::size_t most_calls, const Kinds& kinds = {});

}  // namespace carom::properties
