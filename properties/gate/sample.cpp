// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <utility>

#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/features/quantities.hpp>
#include <carom/properties/gate/sample.hpp>

namespace carom::properties {

std::uint64_t sampled_of(const Family& family) {
  return sampled_of_each_family * static_cast<std::uint64_t>(family.weight);
}

SampledCase sampled_case(const JudgedCase& judged_case, std::vector<std::uint16_t> features) {
  const Collision& collision = judged_case.generated().collision;
  return {true, judged_case.exact().approach(), std::move(features), quantities_of(collision), collision};
}

std::vector<SampledCase> drawn_sample(const Domain& within, const Family& family, std::uint64_t seed,
                                      std::uint64_t cases) {
  std::vector<SampledCase> sample(std::min(cases, sampled_of(family)));
  for (std::uint64_t index = 0; index < sample.size(); ++index) {
    const JudgedCase one(drawn_case_within(within, family, seed, index));
    if (one.is_valid()) {
      sample[index] = sampled_case(one, feature_places_of(one.generated().collision));
    }
  }
  return sample;
}

}  // namespace carom::properties
