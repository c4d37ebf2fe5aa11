// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::subjects {

/// Solves each of its contacts once (`Method::prepare`). Keeps the results, so that the compiler cannot drop the
/// computation.
using Kernel = std::function<void()>;

struct ScalarType {
  std::string_view in_name;  // in the name of the method
  std::string_view in_words;
  int rank;  // lower for fewer bits
};

/// A 3×3 solve of solve3.hpp or solve3_pivoting.hpp.
struct Solve3 {
  std::string_view in_words;
  int rank;  // a lower rank is preferred; 0: the recommended solve
};
inline constexpr Solve3 recommended_solve{"LDLᵀ", 0};
inline constexpr int solve_count = 7;

/// The part of carom/impulse that a method uses.
enum class MethodForm { law, in_basis, in_stable_basis, refined, guaranteed, batch };

/// A way to compute an impulse. The subject for the gate and the kernel for the clock run the same code.
struct Method {
  Subject subject;
  MethodForm form = MethodForm::law;
  ScalarType scalar = {};
  Solve3 solve = recommended_solve;  // unused if the law has no 3×3 system
  bool keeps_inertia_in_world = false;
  /// Converts the collisions to contacts, and returns the kernel that solves each contact once. The conversion is not
  /// measured. Precondition: every collision is valid.
  std::function<Kernel(std::span<const Collision>)> prepare;
};

/// The solvers of carom/impulse, as users compile them.
[[nodiscard]] std::vector<Method> methods();

}  // namespace carom::subjects
