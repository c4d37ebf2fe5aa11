// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace carom::properties {

/// What a name stands for, drawn, as one number.
struct Checksum {
  std::string name;  // a family's; "sweep NAME"; "features"
  std::uint64_t value;
};

/// FNV-1a of the bits of every number that is drawn. Of each family these are the first `count` cases, and of each
/// sweep count/20 at each decade. The last checksum is of general bodies in which each feature is made in turn,
/// count/20 times, and of the features that are then present.
[[nodiscard]] std::vector<Checksum> checksums(std::uint64_t seed, std::uint64_t count);

/// A line of first_thousand.txt: the name, and the value in 16 hexadecimal digits.
[[nodiscard]] std::string line_of(const Checksum& checksum);

}  // namespace carom::properties
