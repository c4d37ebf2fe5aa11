// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <iterator>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/methods.hpp>
#include <carom/subjects/methods/method_groups.hpp>

namespace carom::subjects {

std::vector<Method> methods() {
  std::vector<Method> all;
  for (const auto group :
       {float_methods, double_methods, long_double_methods, double_double_methods, pivoting_float_methods,
        pivoting_double_methods, refined_methods, guaranteed_methods, batch_methods}) {
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
