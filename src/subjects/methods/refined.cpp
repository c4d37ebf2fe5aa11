// SPDX-License-Identifier: BSL-1.0
#include <utility>

#include <carom/impulse/guaranteed.hpp>
#include <carom/impulse/laws.hpp>
#include <carom/impulse/refined.hpp>
#include <carom/subjects/methods/method_groups.hpp>
#include <carom/subjects/methods/solver_method.hpp>

namespace carom::subjects {
namespace {

struct Posed {
  Collision collision;
  impulse::Contact<double> contact;
};

Method guaranteed_method(Law law) {
  Method method;
  impulse::with_law(law, [&](const auto& solver) {
    method = method_of<double>(
        {std::string(name_of(law)) + "-guaranteed", description_in_words(law) + "; the exact N·V⁺ is never negative",
         law, law != Law::frictionless, MethodForm::guaranteed},
        [](const Collision& collision) {
          return Posed{collision, impulse::make_contact<double>(collision)};
        },
        [solver](const Posed& posed, const auto& see) {
          const auto seen_solver = [&](const impulse::Contact<double>& contact, const auto&... approach) {
            if constexpr (sizeof...(approach) == 0) {
              return solver(contact, impulse::normal_velocity(contact), see);
            } else {
              return solver(contact, approach..., see);
            }
          };
          return impulse::guaranteed(posed.collision, posed.contact, seen_solver);
        });
  });
  return method;
}

}  // namespace

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
                             Law::frictionless, false, MethodForm::refined},
                            frictionless),
      solver_method<double>({"reflection-float-refined",
                             "basis-free reflection with LDLᵀ in float and one step of refinement in double; 13 "
                             "digits, but more than 32 ulps of binary64",
                             Law::reflection, true, MethodForm::refined},
                            reflection)};
  for (Method& method : methods) {
    method.subject.name.resize(method.subject.name.rfind('-'));
    // The error is about (c cond(K) 2⁻²⁴)² (refined.hpp): about a hundred ulps of binary64, far below one ulp of
    // binary32.
    method.subject.precision = Precision::binary32;
  }
  return methods;
}

std::vector<Method> guaranteed_methods() {
  std::vector<Method> methods;
  for (const Law law : laws_with_truth) {
    Method method = guaranteed_method(law);
    methods.push_back(
        law == Law::sticking
            ? expected_to_fail(
                  std::move(method),
                  "removing the last ulp of approach loses small momenta, in about one of 10⁴ cases of `structured`")
            : std::move(method));
  }
  return methods;
}

}  // namespace carom::subjects
