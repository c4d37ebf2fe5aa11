// SPDX-License-Identifier: BSL-1.0
#include <cstdint>

#include <carom/properties/cases/family.hpp>
#include <carom/properties/draws/stream.hpp>

namespace carom::properties {

std::vector<const Family*> pointers_to(std::span<const Family> families) {
  std::vector<const Family*> pointers;
  for (const Family& family : families) {
    pointers.push_back(&family);
  }
  return pointers;
}

const Family* family_named(std::string_view name) {
  for (const std::span<const Family> kind : {all_families(), families_beyond_domain()}) {
    for (const Family& family : kind) {
      if (family.name == name) {
        return &family;
      }
    }
  }
  return nullptr;
}

Case drawn_case(const Family& family, std::uint64_t seed, std::uint64_t index) {
  Stream stream = case_stream(seed, family.name, index);
  Case drawn = family.generate(stream);
  drawn.adjusted = stream.adjusted();
  return drawn;
}

Case case_of_any_family(Stream& stream) {
  std::uint64_t weights = 0;
  std::uint64_t simplest = 0;  // the sum of the weights before `generic`
  for (const Family& family : all_families()) {
    simplest = family.name == "generic" ? weights : simplest;
    weights += family.is_valid ? static_cast<std::uint64_t>(family.weight) : 0;
  }
  std::uint64_t chosen = stream.below(weights, simplest);
  for (const Family& family : all_families()) {
    const auto weight = family.is_valid ? static_cast<std::uint64_t>(family.weight) : 0;
    if (chosen < weight) {
      return family.generate(stream);
    }
    chosen -= weight;
  }
  return {};  // not reached: `chosen` is below the sum of the weights
}

}  // namespace carom::properties
