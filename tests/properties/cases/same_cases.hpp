// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace carom::properties {

/// A checksum of all numbers drawn under one name.
struct Checksum {
  std::string name;  // the name of a family, "sweep NAME" or "features"
  std::uint64_t value;
};

/// FNV-1a checksums of the bits of drawn numbers. One checksum for each family covers its first `count` cases. One for
/// each sweep covers count/20 cases at each decade. The last covers each feature, made count/20 times in general
/// bodies, and the features of the results.
[[nodiscard]] std::vector<Checksum> checksums(std::uint64_t seed, std::uint64_t count);

/// The name, and the value in 16 hexadecimal digits, as in first_thousand.txt.
[[nodiscard]] std::string line_of(const Checksum& checksum);

}  // namespace carom::properties
