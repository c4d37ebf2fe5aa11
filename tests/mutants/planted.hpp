// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue.hpp"
#include "rejection.hpp"

namespace carom::mutants {

/// A planted mutant, and the invariants that reject it on the cases of the gate.
struct Rejected {
  const Mutant* mutant;
  Rejecting by;
};

/// Of every planted mutant, in the order of the catalogue. `cases` of each family, times its weight.
[[nodiscard]] std::vector<Rejected> rejected_mutants(std::uint64_t seed, std::uint64_t cases, unsigned jobs);

/// What an invariant does for the verdicts on the planted mutants.
struct Share {
  std::string_view invariant;
  std::uint64_t rejects = 0;
  std::vector<std::string_view> misses;               // mutants that claim it and that it does not reject
  std::vector<std::string_view> alone;                // mutants that no other one rejects
  std::vector<std::string_view> alone_without_truth;  // mutants that none but `backward_error` rejects besides
};

/// In the order of the catalogue of invariants.
[[nodiscard]] std::vector<Share> shares_of(const std::vector<Rejected>& rejected);

/// Invariants that together reject every mutant that any rejects: each time the one that rejects most of what is left.
[[nodiscard]] std::vector<std::string_view> sufficient_invariants(std::vector<Rejected> rejected);

/// The same as if there were no truth to compare with.
[[nodiscard]] std::vector<Rejected> without_truth(std::vector<Rejected> rejected);

/// The matrix of mutants and invariants, and the share of each invariant, in Markdown.
[[nodiscard]] std::string to_markdown(const std::vector<Rejected>& rejected);

}  // namespace carom::mutants
