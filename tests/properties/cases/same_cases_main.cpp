// SPDX-License-Identifier: BSL-1.0
#include <cstdlib>
#include <iostream>

#include "same_cases.hpp"

/// Arguments: COUNT (default 1000) and SEED (default 1).
int main(int count, char** arguments) {
  const std::uint64_t cases = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1000;
  const std::uint64_t seed = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  for (const carom::properties::Checksum& checksum : carom::properties::checksums(seed, cases)) {
    std::cout << line_of(checksum) << '\n';
  }
}
