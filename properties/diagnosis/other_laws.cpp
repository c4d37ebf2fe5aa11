// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/diagnosis/groups.hpp>

namespace carom::properties::diagnosis {

std::vector<Hypothesis> other_laws() {
  std::vector<Hypothesis> all;
  for (const Model model : models_with_truth) {
    all.push_back({"its law were " + std::string(name_of(model)),
                   "the claimed law: this answer is right for another `model` than the claimed one",
                   [model](const KnownCase& one) -> std::optional<Outcome<double>> {
                     if (model == one.model) {
                       return std::nullopt;
                     }
                     return law_answer(one.collision, model).outcome;
                   }});
  }
  return all;
}

}  // namespace carom::properties::diagnosis
