// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <stdexcept>
#include <string>

#include <carom/collision/enum_array.hpp>
#include <carom/collision/expects.hpp>
#include <carom/collision/law.hpp>
#include <carom/collision/outcome.hpp>

namespace carom::oracles {

/// The answer of a law to a collision, exact if T is an exact field.
template <class T>
struct Truth {
  Vector3<T> impulse;  // F on A, −F on B [N s]
  Outcome<T> outcome;
};

/// Throws std::invalid_argument, for a law that is not one of `laws_with_truth`.
[[noreturn]] inline void determines_no_outcome(Law law) {
  throw std::invalid_argument("the law `" + std::string(name_of(law)) + "` determines no outcome");
}

/// The formula by which a law answers a contact that collides. Only the law `rough` has more than one.
enum class Branch {
  only,         // the one formula of `rough` at μ = 0, and of every other law
  inside_cone,  // F lies in the friction cone, so friction acts in full
  on_cone,      // ‖N × F‖ = μ N·F: the cone limits friction
};
inline constexpr std::array all_branches{Branch::only, Branch::inside_cone, Branch::on_cone};
static_assert(counts_from_zero_to(all_branches, Branch::on_cone));

template <class T>
using PerBranch = EnumArray<Branch, T, all_branches.size()>;

/// The branch on the other side of the cone's surface. Precondition: `branch` is not `only`.
[[nodiscard]] constexpr Branch other_side(Branch branch) {
  CAROM_EXPECTS(branch != Branch::only);
  return branch == Branch::inside_cone ? Branch::on_cone : Branch::inside_cone;
}

}  // namespace carom::oracles
