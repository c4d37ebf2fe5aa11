// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace carom::properties {

/// A checksum of all numbers that are drawn under one name.
struct Checksum {
  std::string name;  // the name of a family, "sweep NAME" or "features"
  std::uint64_t value;
};

/// FNV-1a of the bits of every drawn number. For each family it covers the first `count` cases, and for each sweep
/// count/20 cases at each decade. The last checksum covers general bodies in which each feature is made in turn,
/// count/20 times, and the features that the result has.
[[nodiscard]] std::vector<Checksum> checksums(std::uint64_t seed, std::uint64_t count);

/// A line of first_thousand.txt: the name, and the value in 16 hexadecimal digits.
[[nodiscard]] std::string line_of(const Checksum& checksum);

}  // namespace carom::properties
