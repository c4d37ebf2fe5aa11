// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "detection.hpp"

namespace carom::mutants {

/// The numbers of conditional mutants, by the result of their cases.
struct Score {
  std::uint64_t no_case_judged = 0;
  std::uint64_t leaves_truth = 0;
  std::uint64_t within_rounding = 0;
  std::uint64_t killed = 0;

  void add(Sight sight);
  Score& operator+=(const Score& other);

  /// The mutants that some judge could find: they change the exact outcome of a judged case.
  [[nodiscard]] std::uint64_t visible() const { return within_rounding + killed; }
  /// The share of visible mutants that are killed [%].
  [[nodiscard]] double percent() const;
};

/// Scores of mutants whose condition is one feature, and of mutants whose condition is a possible pair.
struct Scores {
  Score singles;
  Score pairs;
};

[[nodiscard]] Scores scores_of(const Detection& detection, Law law, Damage damage);
[[nodiscard]] Scores scores_of(const Detection& detection);

struct Survivor {
  Law law;
  Damage damage;
  std::size_t x;  // equals y if the condition is one feature
  std::size_t y;
  Seen seen;
};

/// Survivors in the order of laws, damages and features. A pair is omitted if one of its features alone has the same
/// result.
[[nodiscard]] std::vector<Survivor> survivors_of(const Detection& detection);

[[nodiscard]] std::string to_text(const Detection& detection, bool markdown);

}  // namespace carom::mutants
