// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "detection.hpp"

namespace carom::mutants {

/// How many conditional mutants of a kind there are, by what the cases show of them.
struct Score {
  std::uint64_t no_case_judged = 0;
  std::uint64_t leaves_truth = 0;
  std::uint64_t within_rounding = 0;
  std::uint64_t killed = 0;

  void add(Sight sight);
  Score& operator+=(const Score& other);

  /// Those that some judge could see: they change the exact outcome of some case that is judged.
  [[nodiscard]] std::uint64_t visible() const { return within_rounding + killed; }
  /// The killed ones of these.
  [[nodiscard]] double percent() const;
};

/// Of mutants whose condition is one feature, and of those whose condition is a pair that can be.
struct Scores {
  Score singles;
  Score pairs;
};

[[nodiscard]] Scores scores_of(const Detection& detection, Model model, Damage damage);
[[nodiscard]] Scores scores_of(const Detection& detection);

/// A conditional mutant that was not killed.
struct Survivor {
  Model model;
  Damage damage;
  std::size_t x;  // the same as y where the condition is one feature
  std::size_t y;
  Seen seen;
};

/// In the order of laws, damages and features. What holds of a single feature holds of any pair with it that is not
/// seen better: such pairs are left out.
[[nodiscard]] std::vector<Survivor> survivors_of(const Detection& detection);

[[nodiscard]] std::string to_text(const Detection& detection, bool markdown);

}  // namespace carom::mutants
