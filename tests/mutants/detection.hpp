// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <vector>

#include <carom/properties/trial/trial.hpp>

#include "damage.hpp"

/// Conditional mutants: sound unless the collision has a feature, or a pair of features, and then damaged. The gate
/// rejects one where it rejects the damaged outcome of any case that has the feature, so that one pass over its cases
/// decides all of them.
namespace carom::mutants {

struct DetectionOptions {
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;  // of each family, times its weight
  unsigned jobs = 1;           // threads
  std::vector<Model> models{models_with_truth.begin(), models_with_truth.end()};
};

/// What the cases show of a conditional mutant: the case that shows most decides.
enum class Sight : std::uint8_t {
  no_case_judged,   // none of the cases with the feature is judged
  leaves_truth,     // in all of them the damage leaves the exact outcome as it is: no judge can see it
  within_rounding,  // in some it does not, and what it changes is no more than is allowed to rounding
  killed,           // in some an invariant is violated
};

/// Of one conditional mutant. The numbers are of the cases until it was killed.
struct Seen {
  float backward_error = 0;   // the largest of those within rounding, in ulps
  std::uint16_t changed = 0;  // cases within rounding; 65535 is that or more
  Sight sight = Sight::no_case_judged;

  Seen& operator+=(const Seen& other);
};

/// What one pass over cases shows of all conditional mutants. Features by their places in all_features().
class Detection {
 public:
  explicit Detection(std::vector<Model> models);

  /// Books a case that collides; `previous` is the collision before it.
  void add(const properties::JudgedCase& one, const Collision& previous);

  Detection& operator+=(const Detection& other);

  /// Of a pair; of a single feature where both are the same. Precondition: x ≤ y, and the model is one of models().
  [[nodiscard]] const Seen& seen(Model model, Damage damage, std::size_t x, std::size_t y) const;

  [[nodiscard]] const std::vector<Model>& models() const { return models_; }

  /// Cases that were booked, those of them that binary64 holds, and sound outcomes of these that were rejected.
  [[nodiscard]] std::uint64_t cases() const { return cases_; }
  [[nodiscard]] std::uint64_t judged() const { return judged_; }
  [[nodiscard]] std::uint64_t sound_rejected() const { return sound_rejected_; }

 private:
  std::vector<Model> models_;
  std::vector<Seen> seen_;
  std::uint64_t cases_ = 0;
  std::uint64_t judged_ = 0;
  std::uint64_t sound_rejected_ = 0;
};

/// Books the colliding ones of the cases that the gate draws.
[[nodiscard]] Detection detect(const DetectionOptions& options);

}  // namespace carom::mutants
