// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <iterator>

#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/laws.hpp>
#include <carom/impulse/reflection_in_basis.hpp>
#include <carom/impulse/world_inertia.hpp>
#include <carom/subjects/methods/solver_method.hpp>

namespace carom::subjects {

template <class S, class Inertia = impulse::PrincipalInertia<S>>
[[nodiscard]] Method law_method(Law law, const std::string& suffix = "") {
  const impulse::Description description = impulse::description_of(law);
  std::string summary(description.law);
  if (!description.solve.empty()) {
    summary += ", 3×3 solve by " + std::string(description.solve);
  }
  if (!description.source.empty()) {
    summary += ", " + std::string(description.source);
  }
  Method method;
  impulse::with_law(law, [&](const auto& solver) {
    method = solver_method<S, Inertia>({std::string(name_of(law)) + suffix, summary, law, law != Law::frictionless},
                                       [solver](const impulse::Contact<S, Inertia>& contact, const auto& see) {
                                         return impulse::apply_impulse(
                                             contact, solver(contact, impulse::normal_velocity(contact), see));
                                       });
  });
  method.keeps_inertia_in_world = !std::is_same_v<Inertia, impulse::PrincipalInertia<S>>;
  return method;
}

template <class S>
[[nodiscard]] std::vector<Method> law_methods() {
  std::vector<Method> methods;
  for (const Law law : laws_with_truth) {
    methods.push_back(law_method<S>(law));
  }
  return methods;
}

/// The methods of `laws_with_truth` with J⁻¹ in world coordinates, as engines keep it.
template <class S>
[[nodiscard]] std::vector<Method> world_methods() {
  std::vector<Method> methods;
  for (const Law law : laws_with_truth) {
    methods.push_back(expected_to_fail(law_method<S, impulse::WorldInertia<S>>(law, "-world"),
                                       "J⁻¹ in world coordinates: loses the angular momentum of slender bodies"));
  }
  return methods;
}

template <class Solve>
inline constexpr Solve3 solve3 = recommended_solve;
template <>
inline constexpr Solve3 solve3<impulse::Adjugate>{"adjugate", 1};
template <>
inline constexpr Solve3 solve3<impulse::EigenLlt>{"LLT of Eigen", 2};
template <>
inline constexpr Solve3 solve3<impulse::EigenLdlt>{"LDLT of Eigen", 3};

/// The basis-free reflection with the 3×3 solve `Solve`. `solve` is the name of the 3×3 solve in the summary.
template <class S, class Solve>
[[nodiscard]] Method reflection_method(const std::string& name, const std::string& solve) {
  Method method = solver_method<S>(
      {name, "basis-free reflection, 3×3 solve by " + solve, Law::reflection},
      [](const impulse::Contact<S>& contact, const auto& see) {
        return impulse::apply_impulse(
            contact, impulse::reflection_impulse<Solve>(contact, impulse::normal_velocity(contact), see));
      });
  method.solve = solve3<Solve>;
  return method;
}

template <class S>
[[nodiscard]] Method reflection_in_basis_method() {
  return expected_to_fail(
      with_form(
          solver_method<S>({"reflection-in-basis", "reflection in the basis {N, T0, T1} of note §2", Law::reflection},
                           [](const impulse::Contact<S>& contact, const auto& see) {
                             return impulse::reflection_in_basis(contact, see);
                           }),
          MethodForm::in_basis),
      "fails near head-on");
}

template <class S>
[[nodiscard]] Method reflection_in_stable_basis_method() {
  return with_form(solver_method<S>({"reflection-in-stable-basis",
                                     "reflection in a basis {N, T0, T1} that does not depend on V⁻", Law::reflection},
                                    [](const impulse::Contact<S>& contact, const auto& see) {
                                      return impulse::reflection_in_stable_basis(contact, see);
                                    }),
                   MethodForm::in_stable_basis);
}

template <class S>
[[nodiscard]] Method coulomb_method() {
  return solver_method<S>(
      {"coulomb", "Coulomb friction that opposes the slip after the impulse, by bisection", Law::coulomb},
      [](const impulse::Contact<S>& contact, const auto& see) { return impulse::coulomb(contact, see); });
}

/// Why some solves fail in binary32: their error is small only relative to the norm of K. Let κ(K) be the condition
/// number of K, and u the unit roundoff. Far from the origin, rounding of positions may move the contact off a thin
/// body, so that κ(K) u ≥ 1. The computed K may then have eigenvalues below λ = 1/m_A + 1/m_B. The impulse pulls the
/// bodies together, or does nothing.
inline constexpr const char* stable_by_norms_alone = "stable only in norm: loses the margin λ of K if κ(K) u ≥ 1";

template <class S>
[[nodiscard]] std::vector<Method> scalar_methods() {
  Method llt = reflection_method<S, impulse::EigenLlt>("reflection-llt", "Eigen's LLT");
  Method adjugate = reflection_method<S, impulse::Adjugate>("reflection-adjugate", "the adjugate");
  if constexpr (precision_of<S> == Precision::binary32) {
    llt = expected_to_fail(std::move(llt), stable_by_norms_alone);
    adjugate = expected_to_fail(std::move(adjugate),
                                "the determinant overflows above about 1e12 kg and underflows below about 1e-12 kg");
  }
  std::vector<Method> methods = law_methods<S>();
  methods.push_back(std::move(llt));
  methods.push_back(std::move(adjugate));
  methods.push_back(reflection_in_basis_method<S>());
  methods.push_back(reflection_in_stable_basis_method<S>());
  methods.push_back(coulomb_method<S>());
  std::ranges::move(world_methods<S>(), std::back_inserter(methods));
  return methods;
}

}  // namespace carom::subjects
