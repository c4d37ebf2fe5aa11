// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <string>

#include <carom/oracles/laws/equations.hpp>

namespace carom::oracles {

/// Checks exactly that an outcome satisfies the equations that define the law. Throws a std::logic_error that names the
/// first equation whose sides differ. T is an exact field. Precondition: the law is one of `laws_with_truth`.
template <class T>
void certify(const BasicCollision<T>& collision, Law law, Approach approach, const Outcome<T>& outcome) {
  for_each_defining_equation(collision, law, approach, [&](const char* name, const auto& equation) {
    const auto sides = equation(collision, outcome);
    for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
      if (sides.left[i] != sides.right[i]) {
        throw std::logic_error(std::string("the truth does not satisfy ") + name);
      }
    }
  });
}

}  // namespace carom::oracles
