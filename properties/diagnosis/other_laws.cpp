// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/diagnosis/hypothesis_groups.hpp>

namespace carom::properties::diagnosis {

std::vector<Hypothesis> other_laws() {
  std::vector<Hypothesis> all;
  for (const Law law : laws_with_truth) {
    all.push_back({"its law were " + std::string(name_of(law)),
                   "the claimed law: this answer is right for another `law` than the claimed one",
                   {[law](Steps& steps, const KnownCase& one) {
                     steps.law = law;
                     steps.has_right_impulse = false;
                     return law != one.law;
                   }}});
  }
  return all;
}

}  // namespace carom::properties::diagnosis
