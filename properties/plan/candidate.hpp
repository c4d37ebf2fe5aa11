// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/subject.hpp>

namespace carom::properties::plan {

/// The axes in which a solver keeps J⁻¹.
enum class Frame { body, world };

/// A built-in method that a plan may choose.
struct Candidate {
  Subject subject;      // its `law` is the law that the method computes
  std::string scalar;   // "float", "double", "long double", "double-double"
  int scalar_rank = 0;  // smaller for fewer bits
  std::string solve;    // "scalar", or the method for the 3×3 system
  int solve_rank = 0;   // 0 for the recommended method
  Frame frame = Frame::body;
  bool is_batch = false;  // solves many contacts at once
};

/// Whether a plan prefers x to y if their times do not decide: by a cheaper law, then by precision, solve, frame and
/// name. The body frame comes first, because it is safer.
[[nodiscard]] bool is_less(const Candidate& x, const Candidate& y);

[[nodiscard]] bool differ_in_precision_alone(const Candidate& x, const Candidate& y);

}  // namespace carom::properties::plan
