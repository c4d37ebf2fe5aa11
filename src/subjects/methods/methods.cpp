// SPDX-License-Identifier: BSL-1.0
#include <iterator>
#include <type_traits>
#include <utility>

#include <carom/impulse/numbers/double_double.hpp>
#include <carom/impulse/solve3_pivoting.hpp>
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

template <>
inline constexpr Solve3 solve3<impulse::EigenPartialPivLu>{"PartialPivLU of Eigen", 4};
template <>
inline constexpr Solve3 solve3<impulse::EigenFullPivLu>{"FullPivLU of Eigen", 5};
template <>
inline constexpr Solve3 solve3<impulse::EigenColPivHouseholderQr>{"ColPivHouseholderQR of Eigen", 6};

template <class S>
static std::vector<Method> pivoting_methods() {
  std::vector<Method> methods{
      reflection_method<S, impulse::EigenLdlt>("reflection-ldlt-eigen", "Eigen's LDLT"),
      reflection_method<S, impulse::EigenPartialPivLu>("reflection-partial-lu", "Eigen's PartialPivLU"),
      reflection_method<S, impulse::EigenFullPivLu>("reflection-full-lu", "Eigen's FullPivLU"),
      reflection_method<S, impulse::EigenColPivHouseholderQr>("reflection-qr", "Eigen's ColPivHouseholderQR")};
  if constexpr (std::is_same_v<S, float>) {
    for (Method& method : methods) {
      method = expected_to_fail(std::move(method), stable_by_norms_alone);
    }
  }
  return methods;
}

std::vector<Method> pivoting_float_methods() { return pivoting_methods<float>(); }

std::vector<Method> pivoting_double_methods() { return pivoting_methods<double>(); }

}  // namespace carom::subjects
