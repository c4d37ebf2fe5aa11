// SPDX-License-Identifier: BSL-1.0
#include <iterator>

#include <carom/properties/diagnosis/hypothesis.hpp>
#include <carom/properties/diagnosis/hypothesis_groups.hpp>

namespace carom::properties::diagnosis {

std::span<const Hypothesis> all_hypotheses() {
  static const std::vector<Hypothesis> all = [] {
    std::vector<Hypothesis> joined;
    for (const auto group : {misused_impulses, misread_contacts, misread_bodies, other_laws}) {
      std::ranges::move(group(), std::back_inserter(joined));
    }
    return joined;
  }();
  return all;
}

bool explains(const Hypothesis& hypothesis, const KnownCase& one) {
  constexpr double small_share = 0x1p-10;  // rounding is less than this share of a visible error
  const std::optional<Outcome<double>> predicted = hypothesis.answer(one);
  return predicted && energy_distance(one.collision, *predicted, one.answered) <=
                          small_share * energy_distance(one.collision, one.truth, one.answered);
}

}  // namespace carom::properties::diagnosis
