// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/reflection_in_basis.hpp>
#include <carom/subjects/methods/solver_method.hpp>

namespace carom::subjects {

template <class S>
[[nodiscard]] Method frictionless_method() {
  return solver_method<S>({"frictionless", "impulse along the normal, eq. 18", Model::frictionless},
                          [](const impulse::Contact<S>& contact) { return impulse::frictionless(contact); });
}

/// The basis-free reflection with one of solve3.hpp, which is called `solve` in the summary.
template <class S, class Solve>
[[nodiscard]] Method reflection_method(const std::string& name, const std::string& solve) {
  return solver_method<S>({name, "basis-free reflection, 3×3 solve by " + solve, Model::reflection},
                          [](const impulse::Contact<S>& contact) { return impulse::reflection<Solve>(contact); });
}

/// `basis_of` gives the basis of a contact, for the matrix that is shown.
template <class S, class BasisOf, class Solve>
[[nodiscard]] Method basis_method(Claim claim, BasisOf basis_of, Solve solve) {
  Method method = solver_method<S>(std::move(claim), solve);
  method.subject.collision_matrix = [basis_of](const Collision& collision) -> Matrix3<long double> {
    const auto contact = impulse::make_contact<S>(collision);
    return impulse::printed_collision_matrix<S>(contact, basis_of(contact)).template cast<long double>();
  };
  return method;
}

template <class S>
[[nodiscard]] Method reflection_in_basis_method() {
  return expected_to_fail(
      basis_method<S>(
          {"reflection-in-basis", "reflection in the basis {N, T0, T1} as note §2 prints it", Model::reflection},
          impulse::tangent_basis<S>,
          [](const impulse::Contact<S>& contact) { return impulse::reflection_in_basis(contact); }),
      "fails near head-on");
}

template <class S>
[[nodiscard]] Method reflection_in_stable_basis_method() {
  return basis_method<S>(
      {"reflection-in-stable-basis", "reflection in a basis {N, T0, T1} that does not depend on V⁻", Model::reflection},
      impulse::stable_tangent_basis<S>,
      [](const impulse::Contact<S>& contact) { return impulse::reflection_in_stable_basis(contact); });
}

/// What every scalar type has.
template <class S>
[[nodiscard]] std::vector<Method> scalar_methods() {
  Method adjugate = reflection_method<S, impulse::Adjugate>("reflection-adjugate", "the adjugate");
  if constexpr (precision_of<S> == Precision::binary32) {
    adjugate = expected_to_fail(std::move(adjugate), "the determinant under- and overflows from about 1e±12 kg on");
  }
  return {frictionless_method<S>(),
          reflection_method<S, impulse::Ldlt>("reflection", "LDLᵀ"),
          reflection_method<S, impulse::EigenLlt>("reflection-llt", "Eigen's LLT"),
          std::move(adjugate),
          reflection_in_basis_method<S>(),
          reflection_in_stable_basis_method<S>()};
}

}  // namespace carom::subjects
