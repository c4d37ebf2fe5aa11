// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <carom/properties/invariants/invariant.hpp>

namespace carom::properties {

/// A theorem that Coq checks.
struct Theorem {
  std::string_view name;
  std::string_view file;  // in properties/proofs
};

/// What the theorems of an invariant are of.
enum class ProvedOf {
  every_impulse,  // whatever the law, or of the collision matrix, which no law changes
  its_laws,       // those that it is claimed for and that determine one outcome
};

/// An invariant that is proved of the exact laws, not only tested.
struct Proved {
  std::string_view invariant;
  ProvedOf of;
  std::vector<Theorem> theorems;  // one at least
};

/// In the order of the catalogue. Not among them is what speaks of a program (`finite`), or what defines its law
/// (`slip_opposed`).
[[nodiscard]] std::span<const Proved> proved_invariants();

/// The theorems that prove the invariant of this name; empty where it is tested alone.
[[nodiscard]] std::span<const Theorem> theorems_of(std::string_view invariant);

/// The models, of those that it is claimed for, of which the invariant is proved; empty where it is tested alone.
[[nodiscard]] std::vector<Model> proved_models(const Invariant& invariant);

}  // namespace carom::properties
