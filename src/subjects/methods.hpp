// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::subjects {

/// Solves the contacts that it was prepared with, once each, from memory to memory. What it computes is kept where the
/// compiler cannot drop it.
using Kernel = std::function<void()>;

/// What a method computes in.
struct ScalarType {
  std::string_view in_name;  // of the method
  std::string_view in_words;
  std::string_view in_code;
  int rank;  // the fewer bits, the less
};

/// A 3×3 solve of solve3.hpp or solve3_pivoting.hpp.
struct Solve3 {
  std::string_view in_words;
  std::string_view in_code;
  int rank;  // 0: the one that is recommended
  bool pivots = false;
};
inline constexpr Solve3 recommended_solve{"LDLᵀ", "Ldlt", 0};
inline constexpr int solve_count = 7;

/// Which text of carom/impulse a method is.
enum class MethodForm { law, in_basis, in_stable_basis, refined, guaranteed, batch };

/// A way to compute an impulse, as what the gate judges and as what a clock measures: the same text in both.
struct Method {
  Subject subject;
  MethodForm form = MethodForm::law;
  ScalarType scalar = {};
  Solve3 solve = recommended_solve;  // read where the law has a 3×3 system
  bool keeps_inertia_in_world = false;
  /// Lays the collisions out as the method reads them (contacts in its scalar type; not part of what is measured), and
  /// gives what solves them all once. Precondition: every collision is valid.
  std::function<Kernel(std::span<const Collision>)> prepare;
};

/// The solvers of carom/impulse, as users compile them.
[[nodiscard]] std::vector<Method> methods();

}  // namespace carom::subjects
