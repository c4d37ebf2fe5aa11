// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <carom/properties/families/family.hpp>

#include "input.hpp"

/// Cases as bytes, in two forms that the first byte tells apart. Below 120: the family of that number, counted round,
/// draws from the integers that follow. Below 128: one beyond the claimed domain does. From there on: which body is
/// immovable (1: A, 2: B), and then the numbers of a collision as they stand, valid or not. What is worth keeping is
/// kept in the second form, which outlives a change of the families.
namespace carom::fuzz {

struct ReadCase {
  properties::Case one;
  bool is_of_family = false;  // of the claimed domain
};

[[nodiscard]] ReadCase case_from(Input& input);

/// What the family of that number draws as the case of that index, seed 1, in the first form.
[[nodiscard]] std::vector<std::uint8_t> bytes_of_family(std::size_t family, std::uint64_t index);

/// The same of the families beyond the claimed domain.
[[nodiscard]] std::vector<std::uint8_t> bytes_beyond_domain(std::size_t family, std::uint64_t index);

/// The second form.
[[nodiscard]] std::vector<std::uint8_t> bytes_of(const Collision& collision);

}  // namespace carom::fuzz
