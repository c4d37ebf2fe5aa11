// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/properties/diagnosis/fault.hpp>

namespace carom::properties::diagnosis {

/// Finds out whether a subject that claims a higher precision stores its answers in binary32.
class NarrowAnswers {
 public:
  void add(const Collision& collision, const Outcome<double>& outcome);

  /// Whether every changed velocity is a vector of binary32 numbers, and at least `least_violated` outcomes tell this.
  /// An outcome tells it by a number of more than 20 significant bits, if the number before the impulse does not fit
  /// binary32. By chance, a number of binary64 with so many bits ends within the 24 bits of binary32 once in 2²⁹.
  /// Shorter numbers, such as 0.5, tell nothing.
  [[nodiscard]] bool are_binary32() const;

  /// The fault of a subject that claims `claimed`. Precondition: are_binary32().
  [[nodiscard]] Fault fault(Precision claimed) const;

 private:
  std::size_t count_ = 0;
  std::size_t telling_ = 0;
  bool fit_ = true;  // each changed number is a binary32 number
};

struct FaultOfKind {
  AnswerKind kind;
  Fault fault;
};

/// The faults of answers to valid collisions that are not outcomes of finite numbers, one for each kind of answer.
[[nodiscard]] std::vector<FaultOfKind> faults_without_outcome(std::span<const ViolatedCase> examples);

}  // namespace carom::properties::diagnosis
