// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <vector>

#include <carom/properties/trial/trial.hpp>

#include "damage.hpp"

/// A conditional mutant is a sound solver that returns a damaged outcome if the collision has a given feature or pair
/// of features. The feature or pair is the mutant's condition. The gate rejects the mutant if it rejects the damaged
/// outcome of any case with the condition. So one pass over the cases decides all mutants.
namespace carom::mutants {

struct DetectionOptions {
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;  // for each family, times its weight
  unsigned jobs = 1;           // threads
  std::vector<Law> laws{laws_with_truth.begin(), laws_with_truth.end()};
};

/// The result of all cases for a conditional mutant: the last in this list among the results of single cases.
enum class Sight : std::uint8_t {
  no_case_judged,   // no case with the condition is judged
  leaves_truth,     // the damage changes the exact outcome of no case, so no judge can find the mutant
  within_rounding,  // in some case the damage changes the outcome, but by no more than the allowed rounding
  killed,           // in some case an invariant is violated
};

/// The result for one conditional mutant. After a case kills the mutant, later cases may be left out.
struct Seen {
  float backward_error = 0;   // the largest in the cases within rounding [ulps]
  std::uint16_t changed = 0;  // cases within rounding; 65535 means at least that many
  Sight sight = Sight::no_case_judged;

  Seen& operator+=(const Seen& other);
};

/// The result of one pass, for all conditional mutants. A feature is given by its index in all_features().
class Detection {
 public:
  explicit Detection(std::vector<Law> laws);

  /// Records a colliding case; `previous` is the collision before it.
  void add(const properties::JudgedCase& one, const Collision& previous);

  Detection& operator+=(const Detection& other);

  /// The result for a pair, or for a single feature if x = y. Preconditions: x ≤ y, and the law is one of laws().
  [[nodiscard]] const Seen& seen(Law law, Damage damage, std::size_t x, std::size_t y) const;

  [[nodiscard]] const std::vector<Law>& laws() const { return laws_; }

  [[nodiscard]] std::uint64_t cases() const { return cases_; }
  [[nodiscard]] std::uint64_t judged() const { return judged_; }
  [[nodiscard]] std::uint64_t sound_rejected() const { return sound_rejected_; }

 private:
  std::vector<Law> laws_;
  std::vector<Seen> seen_;
  std::uint64_t cases_ = 0;
  std::uint64_t judged_ = 0;
  std::uint64_t sound_rejected_ = 0;
};

/// Records the colliding cases among those that the gate draws.
[[nodiscard]] Detection detect(const DetectionOptions& options);

}  // namespace carom::mutants
