// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "known_defects.hpp"

/// Solvers with several of the known defects at once, and what a report says of them.
namespace carom::mutants {

/// The law of these solvers. Every known defect can be planted in a solver for it.
inline constexpr Law law_of_planted = Law::reflection;

using Together = std::vector<const KnownDefect*>;

/// The known defects of which each alone violates at least a hundredth of the cases.
[[nodiscard]] std::vector<const KnownDefect*> frequent_defects(std::span<const KnownDefect> known);

/// `count` different sets of `size` of the defects, drawn by the seed.
[[nodiscard]] std::vector<Together> drawn_together(std::span<const KnownDefect* const> defects, std::size_t size,
                                                   std::size_t count, std::uint64_t seed);

/// The gate's report on a solver with these defects.
struct Told {
  Together planted;
  Together named;     // in one of the report's first 60 lines, each by its own fault
  std::string lines;  // the first 60 lines of the report
};

/// Judges the solvers, and reads their reports.
[[nodiscard]] std::vector<Told> told_of(std::span<const Together> all);

[[nodiscard]] std::string names_of(const Together& defects);

}  // namespace carom::mutants
