// SPDX-License-Identifier: BSL-1.0
#include <iterator>

#include <carom/impulse/numbers/double_double.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/methods.hpp>
#include <carom/subjects/methods/method_groups.hpp>
#include <carom/subjects/methods/scalar_methods.hpp>

namespace carom::subjects {

std::vector<Method> methods() {
  std::vector<Method> all;
  // Rounding the outcome of double-double to long double costs at most half an ulp of `extended`.
  for (const auto group :
       {scalar_methods<float>, scalar_methods<double>, scalar_methods<long double>, law_methods<impulse::DoubleDouble>,
        pivoting_float_methods, pivoting_double_methods, refined_methods, guaranteed_methods, batch_methods}) {
    std::ranges::move(group(), std::back_inserter(all));
  }
  return all;
}

std::vector<Subject> built_in_subjects() {
  std::vector<Subject> subjects;
  for (Method& method : methods()) {
    subjects.push_back(std::move(method.subject));
  }
  return subjects;
}

}  // namespace carom::subjects
