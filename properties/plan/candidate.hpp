// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/subject.hpp>

namespace carom::properties::plan {

/// In which coordinates a solver keeps J⁻¹.
enum class Frame { body, world };

/// A way to solve contacts that a plan may choose.
struct Candidate {
  Subject subject;      // its model is the law that it computes
  std::string scalar;   // "float", "double", "long double", "double-double"
  int scalar_rank = 0;  // the fewer bits, the less
  std::string solve;    // "scalar", or how the 3×3 system is solved
  int solve_rank = 0;   // 0: as is recommended
  Frame frame = Frame::body;
  bool is_batch = false;  // many contacts at once
};

/// Which of two is less where the clock does not tell: by the law (`lesser_laws` of the one asked for), then the
/// precision, the solve, and the frame, of which that of the body is the safer.
[[nodiscard]] bool is_less(const Candidate& x, const Candidate& y);

/// Whether they are the same but for their precision.
[[nodiscard]] bool differ_in_precision_alone(const Candidate& x, const Candidate& y);

}  // namespace carom::properties::plan
