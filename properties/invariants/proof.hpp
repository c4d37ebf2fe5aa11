// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>
#include <vector>

namespace carom::properties {

/// A theorem that Coq checks.
struct Theorem {
  std::string_view name;
  std::string_view file;  // in properties/proofs
};

/// The laws for which the theorems of an invariant hold.
enum class ProvedOf {
  every_impulse,  // every law, or the collision matrix, which does not depend on the law
  its_laws,       // the laws that it is claimed for and that determine one outcome
};

/// The proof that an invariant follows from the exact laws. Without theorems, an invariant is only tested, because it
/// is about a program (`finite`) or defines its law (`slip_opposed`).
struct Proof {
  ProvedOf of = ProvedOf::its_laws;
  std::vector<Theorem> theorems = {};
};

}  // namespace carom::properties
