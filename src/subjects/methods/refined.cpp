// SPDX-License-Identifier: BSL-1.0
#include <carom/impulse/refined.hpp>
#include <carom/subjects/methods/method_groups.hpp>
#include <carom/subjects/methods/solver_method.hpp>

namespace carom::subjects {

std::vector<Method> refined_methods() {
  const auto frictionless = [](const impulse::Contact<double>& contact, const auto& /*see*/) {
    return impulse::frictionless_refined<float>(contact);
  };
  const auto reflection = [](const impulse::Contact<double>& contact, const auto& see) {
    return impulse::reflection_refined<float, impulse::Ldlt>(contact, see);
  };
  std::vector<Method> methods{
      solver_method<double>({"frictionless-float-refined",
                             "frictionless law in float with one step of refinement in double; 13 digits, but more "
                             "than 32 ulps of binary64",
                             Law::frictionless, false},
                            frictionless),
      solver_method<double>({"reflection-float-refined",
                             "basis-free reflection with LDLᵀ in float and one step of refinement in double; 13 "
                             "digits, but more than 32 ulps of binary64",
                             Law::reflection},
                            reflection)};
  for (Method& method : methods) {
    method.form = MethodForm::refined;
    method.subject.name.resize(method.subject.name.rfind('-'));
    // The error is about (c cond(K) 2⁻²⁴)² (refined.hpp): about a hundred ulps of binary64, far below one ulp of
    // binary32.
    method.subject.precision = Precision::binary32;
  }
  return methods;
}

}  // namespace carom::subjects
