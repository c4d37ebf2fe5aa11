// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <carom/collision/subject.hpp>

namespace carom::subjects {

/// Solves the contacts that it was prepared with, once each, from memory to memory. What it computes is kept where the
/// compiler cannot drop it.
using Kernel = std::function<void()>;

/// A way to compute an impulse, as what the gate judges and as what a clock measures: the same text in both.
struct Method {
  Subject subject;
  /// Lays the collisions out as the method reads them (contacts in its scalar type; not part of what is measured), and
  /// gives what solves them all once. Precondition: every collision is valid.
  std::function<Kernel(std::span<const Collision>)> prepare;
};

/// The solvers of carom/impulse, as users compile them.
[[nodiscard]] std::vector<Method> methods();

}  // namespace carom::subjects
