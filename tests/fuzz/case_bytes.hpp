// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <carom/properties/cases/family.hpp>

#include "target.hpp"

/// Cases as bytes, in a drawn and a plain form. The first byte selects the form:
///
///  below 120:     drawn: the family with this number (modulo the number of families) draws from the integers after it
///  below 128:     drawn, by a family beyond the claimed domain (law.cpp)
///  128 and above: plain: a byte for the immovable body (1: A, 2: B), then the numbers of a collision, valid or not
///
/// Inputs in corpora and regressions use the plain form, because it does not depend on the families.
namespace carom::fuzz {

struct ReadCase {
  properties::Case one;
  bool is_of_family = false;  // drawn by a family of the claimed domain
};

[[nodiscard]] ReadCase case_from(Input& input);

/// The drawn form of the case that the family with this number draws for this index and seed 1.
[[nodiscard]] std::vector<std::uint8_t> bytes_of_family(std::size_t family, std::uint64_t index);

/// Like bytes_of_family, for a family beyond the claimed domain.
[[nodiscard]] std::vector<std::uint8_t> bytes_beyond_domain(std::size_t family, std::uint64_t index);

/// The plain form of the collision.
[[nodiscard]] std::vector<std::uint8_t> bytes_of(const Collision& collision);

}  // namespace carom::fuzz
