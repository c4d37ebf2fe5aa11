// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue.hpp"
#include "rejection.hpp"

namespace carom::mutants {

struct Rejected {
  const Mutant* mutant;
  Rejecting by;
};

/// Judges every planted mutant on `cases` cases of each family, times the family's weight.
[[nodiscard]] std::vector<Rejected> rejected_mutants(std::uint64_t seed, std::uint64_t cases, unsigned jobs);

/// The contribution of an invariant to the verdicts on planted mutants.
struct Share {
  std::string_view invariant;
  std::uint64_t rejects = 0;
  std::vector<std::string_view> misses;               // mutants that claim the invariant but are not rejected by it
  std::vector<std::string_view> alone;                // mutants that no other invariant rejects
  std::vector<std::string_view> alone_without_truth;  // mutants that only the invariant and `backward_error` reject
};

[[nodiscard]] std::vector<Share> shares_of(const std::vector<Rejected>& rejected);

/// A greedy choice of invariants that together reject every rejected mutant.
[[nodiscard]] std::vector<std::string_view> sufficient_invariants(std::vector<Rejected> rejected);

/// The mutants of `rejected`, without the rejections by `backward_error`.
[[nodiscard]] std::vector<Rejected> without_truth(std::vector<Rejected> rejected);

[[nodiscard]] std::string to_markdown(const std::vector<Rejected>& rejected);

}  // namespace carom::mutants
