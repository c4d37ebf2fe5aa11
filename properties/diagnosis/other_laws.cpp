// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/diagnosis/hypothesis_groups.hpp>

namespace carom::properties::diagnosis {

std::vector<Hypothesis> other_laws() {
  std::vector<Hypothesis> all;
  for (const Law law : laws_with_truth) {
    all.push_back({"its law were " + std::string(name_of(law)),
                   "the claimed law: this answer is right for another `law` than the claimed one",
                   [law](const KnownCase& one) -> std::optional<Outcome<double>> {
                     if (law == one.law) {
                       return std::nullopt;
                     }
                     return law_answer(one.collision, law).outcome;
                   }});
  }
  return all;
}

}  // namespace carom::properties::diagnosis
