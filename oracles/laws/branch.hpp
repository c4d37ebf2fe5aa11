// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/collision/enum_array.hpp>
#include <carom/collision/expects.hpp>

namespace carom::oracles {

/// By which of its formulas a law answers to a contact that collides.
enum class Branch {
  only,         // there is no friction: by the law, or since μ = 0
  inside_cone,  // friction does all that it is to do
  on_cone,      // ‖N × F‖ = μ N·F: friction does what it can
};
inline constexpr std::array all_branches{Branch::only, Branch::inside_cone, Branch::on_cone};
static_assert(counts_from_zero_to(all_branches, Branch::on_cone));

template <class T>
using PerBranch = EnumArray<Branch, T, all_branches.size()>;

/// The other side of the cone's surface. Precondition: not `only`.
[[nodiscard]] constexpr Branch other_side(Branch branch) {
  CAROM_EXPECTS(branch != Branch::only);
  return branch == Branch::inside_cone ? Branch::on_cone : Branch::inside_cone;
}

}  // namespace carom::oracles
