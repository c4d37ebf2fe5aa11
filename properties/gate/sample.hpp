// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <vector>

#include <carom/oracles/judge/exact_case.hpp>
#include <carom/properties/families/family.hpp>
#include <carom/properties/trial/trial.hpp>

/// Cases that are looked at closely: what those have in common that violate something says where a subject is wrong.
namespace carom::properties {

/// What a sampled case is like.
struct SampledCase {
  bool is_valid = false;
  oracles::Approach approach = oracles::Approach::inert;  // of a valid one
  std::vector<std::uint16_t> features = {};               // by their places in all_features(), ascending
  std::vector<float> quantities = {};                     // decimal logarithms, as all_compared_quantities() has them
};

/// Of each family the first so many cases, times its weight, are sampled.
inline constexpr std::uint64_t sampled_of_each_family = 1000;
[[nodiscard]] std::uint64_t sampled_of(const Family& family);

/// Of a valid case with these features.
[[nodiscard]] SampledCase sampled_case(const JudgedCase& judged_case, std::vector<std::uint16_t> features);

/// Draws the sampled ones among the first `cases` of the family, by their numbers.
[[nodiscard]] std::vector<SampledCase> drawn_sample(const Family& family, std::uint64_t seed, std::uint64_t cases);

}  // namespace carom::properties
