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

/// The laws that the theorems of an invariant are about.
enum class ProvedOf {
  every_impulse,  // whatever the law, or of the collision matrix, which no law changes
  its_laws,       // those that it is claimed for and that determine one outcome
};

/// Why an invariant follows from the exact laws. Without theorems it is tested alone: it speaks of a program
/// (`finite`), or it defines its law (`slip_opposed`).
struct Proof {
  ProvedOf of = ProvedOf::its_laws;
  std::vector<Theorem> theorems = {};
};

}  // namespace carom::properties
