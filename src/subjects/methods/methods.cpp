// SPDX-License-Identifier: BSL-1.0
#include <iterator>
#include <type_traits>
#include <utility>

#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/laws.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/impulse/reflection_in_basis.hpp>
#include <carom/impulse/solve3_pivoting.hpp>
#include <carom/impulse/world_inertia.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/methods.hpp>
#include <carom/subjects/methods/method_groups.hpp>
#include <carom/subjects/methods/solver_method.hpp>

namespace carom::subjects {
namespace {

template <class S, class Inertia = impulse::PrincipalInertia<S>>
Method law_method(Law law, const std::string& suffix = "") {
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
std::vector<Method> law_methods() {
  std::vector<Method> methods;
  for (const Law law : laws_with_truth) {
    methods.push_back(law_method<S>(law));
  }
  return methods;
}

/// The methods of `laws_with_truth` with J⁻¹ in world coordinates, as engines keep it.
template <class S>
std::vector<Method> world_methods() {
  std::vector<Method> methods;
  for (const Law law : laws_with_truth) {
    methods.push_back(expected_to_fail(law_method<S, impulse::WorldInertia<S>>(law, "-world"),
                                       "J⁻¹ in world coordinates: loses the angular momentum of slender bodies"));
  }
  return methods;
}

template <class Solve>
constexpr Solve3 solve3 = recommended_solve;
template <>
constexpr Solve3 solve3<impulse::Adjugate>{"adjugate", 1};
template <>
constexpr Solve3 solve3<impulse::EigenLlt>{"LLT of Eigen", 2};
template <>
constexpr Solve3 solve3<impulse::EigenLdlt>{"LDLT of Eigen", 3};
template <>
constexpr Solve3 solve3<impulse::EigenPartialPivLu>{"PartialPivLU of Eigen", 4};
template <>
constexpr Solve3 solve3<impulse::EigenFullPivLu>{"FullPivLU of Eigen", 5};
template <>
constexpr Solve3 solve3<impulse::EigenColPivHouseholderQr>{"ColPivHouseholderQR of Eigen", 6};

/// The basis-free reflection with the 3×3 solve `Solve`. `solve` is the name of the 3×3 solve in the summary.
template <class S, class Solve>
Method reflection_method(const std::string& name, const std::string& solve) {
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
Method reflection_in_basis_method() {
  return expected_to_fail(solver_method<S>({"reflection-in-basis", "reflection in the basis {N, T0, T1} of note §2",
                                            Law::reflection, true, MethodForm::in_basis},
                                           [](const impulse::Contact<S>& contact, const auto& see) {
                                             return impulse::reflection_in_basis(contact, see);
                                           }),
                          "fails near head-on");
}

template <class S>
Method reflection_in_stable_basis_method() {
  return solver_method<S>({"reflection-in-stable-basis", "reflection in a basis {N, T0, T1} that does not depend on V⁻",
                           Law::reflection, true, MethodForm::in_stable_basis},
                          [](const impulse::Contact<S>& contact, const auto& see) {
                            return impulse::reflection_in_stable_basis(contact, see);
                          });
}

template <class S>
Method coulomb_method() {
  return solver_method<S>(
      {"coulomb", "Coulomb friction that opposes the slip after the impulse, by bisection", Law::coulomb},
      [](const impulse::Contact<S>& contact, const auto& see) { return impulse::coulomb(contact, see); });
}

/// Why some solves fail in binary32: their error is small only relative to the norm of K. Let κ(K) be the condition
/// number of K, and u the unit roundoff. Far from the origin, rounding of positions may move the contact off a thin
/// body, so that κ(K) u ≥ 1. The computed K may then have eigenvalues below λ = 1/m_A + 1/m_B. The impulse pulls the
/// bodies together, or does nothing.
constexpr const char* stable_by_norms_alone = "stable only in norm: loses the margin λ of K if κ(K) u ≥ 1";

template <class S>
std::vector<Method> scalar_methods() {
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

/// Reflection by the pivoting decompositions of Eigen.
template <class S>
std::vector<Method> pivoting_methods() {
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

}  // namespace

std::vector<Method> methods() {
  std::vector<Method> all;
  // Rounding the outcome of double-double to long double costs at most half an ulp of `extended`.
  for (const auto group :
       {scalar_methods<float>, scalar_methods<double>, scalar_methods<long double>, law_methods<impulse::DoubleDouble>,
        pivoting_methods<float>, pivoting_methods<double>, refined_methods, guaranteed_methods, batch_methods}) {
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
