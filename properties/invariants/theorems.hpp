// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace carom::properties {

/// A theorem that Coq checks.
struct Theorem {
  std::string_view name;
  std::string_view file;  // in properties/proofs
};

/// An invariant that is proved of the exact laws, not only tested.
struct Proved {
  std::string_view invariant;
  std::vector<Theorem> theorems;  // one at least
};

/// In the order of the catalogue. Not among them is what speaks of a program (`finite`), or what defines its law
/// (`slip_opposed`).
[[nodiscard]] std::span<const Proved> proved_invariants();

/// The theorems that prove the invariant of this name; empty where it is tested alone.
[[nodiscard]] std::span<const Theorem> theorems_of(std::string_view invariant);

}  // namespace carom::properties
