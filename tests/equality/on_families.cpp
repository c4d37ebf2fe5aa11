// SPDX-License-Identifier: BSL-1.0
#include "on_families.hpp"

#include "wild.hpp"

namespace carom::equality {

void compare_on_families(std::span<Examined> examined, std::uint64_t cases, Relations relations, Agreement& agreement) {
  for (const properties::Family& family : properties::all_families()) {
    for (std::uint64_t index = 0; index < cases; ++index) {
      compare_judges(properties::drawn_case(family, seed, index), examined, relations,
                     std::string(family.name) + ' ' + std::to_string(index), agreement);
      if ((index + family.name.size()) % 5 != 0) {
        continue;
      }
      const std::string wild = "wild " + std::string(family.name);
      properties::Stream of_wild = properties::case_stream(seed, wild, index);
      compare_judges(wild_case(of_wild), examined, relations, wild + ' ' + std::to_string(index), agreement);
    }
  }
}

std::string joined(const Agreement& agreement) {
  std::string text;
  for (const std::string& difference : agreement.differences) {
    text += difference + '\n';
  }
  return text;
}

}  // namespace carom::equality
