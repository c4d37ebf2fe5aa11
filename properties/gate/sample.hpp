// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <vector>

#include <carom/oracles/judge/exact_case.hpp>
#include <carom/properties/cases/domain.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/gate/trial.hpp>

/// Sampled cases, with the properties that a diagnosis compares.
namespace carom::properties {

struct SampledCase {
  bool is_valid = false;
  oracles::Approach approach = oracles::Approach::inert;  // of a valid case
  std::vector<std::uint16_t> features = {};               // places in all_features(), ascending
  std::vector<float> quantities = {};  // decimal logarithms, in the order of all_compared_quantities()
  Collision collision = {};
};

/// This many of a family's first cases, times the family's weight, are sampled.
inline constexpr std::uint64_t sampled_of_each_family = 1000;
[[nodiscard]] std::uint64_t sampled_of(const Family& family);

/// A valid case with these features (indices of all_features()).
[[nodiscard]] SampledCase sampled_case(const JudgedCase& judged_case, std::vector<std::uint16_t> features);

/// Draws the sampled cases among the first `cases` of the family. Invalid cases stay default-constructed.
[[nodiscard]] std::vector<SampledCase> drawn_sample(const Domain& within, const Family& family, std::uint64_t seed,
                                                    std::uint64_t cases);

}  // namespace carom::properties
