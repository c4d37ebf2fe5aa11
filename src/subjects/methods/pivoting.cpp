// SPDX-License-Identifier: BSL-1.0
#include <type_traits>
#include <utility>

#include <carom/impulse/solve3_pivoting.hpp>
#include <carom/subjects/methods/method_groups.hpp>
#include <carom/subjects/methods/scalar_methods.hpp>

namespace carom::subjects {

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
