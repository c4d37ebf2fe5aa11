// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/subject.hpp>

namespace carom::properties::plan {

/// The coordinates in which a solver keeps J⁻¹.
enum class Frame { body, world };

/// A way to solve contacts that a plan may choose.
struct Candidate {
  Subject subject;      // its `law` is the law that it computes
  std::string scalar;   // "float", "double", "long double", "double-double"
  int scalar_rank = 0;  // smaller for fewer bits
  std::string solve;    // "scalar", or the method that solves the 3×3 system
  int solve_rank = 0;   // 0 for the recommended method
  Frame frame = Frame::body;
  bool is_batch = false;  // solves many contacts at once
};

/// Whether a plan prefers x to y, if their times do not decide. The law decides first (a cheaper one is preferred),
/// then the precision, the solve, the frame and the name. The body frame is preferred, because it is safer.
[[nodiscard]] bool is_less(const Candidate& x, const Candidate& y);

/// Whether two candidates differ only in precision.
[[nodiscard]] bool differ_in_precision_alone(const Candidate& x, const Candidate& y);

}  // namespace carom::properties::plan
