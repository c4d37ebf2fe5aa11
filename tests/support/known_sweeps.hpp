// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <carom/collision/collision.hpp>

namespace carom::unit {

/// The collisions with the numbers k = 0, 1, …, count − 1. They differ in one parameter, which grows or shrinks by
/// powers of two.
struct Sweep {
  std::string name;
  int count;
  std::function<Collision(int)> collision;
};

/// Sweeps for tests against recorded values. They do not depend on the families.
[[nodiscard]] std::vector<Sweep> sweeps();

}  // namespace carom::unit
