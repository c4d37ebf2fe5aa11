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

template <class S>
[[nodiscard]] Matrix3<long double> printed_matrix(const Collision& collision) {
  const auto contact = impulse::make_contact<S>(collision);
  const Matrix3<S> basis = impulse::tangent_basis(contact);
  return impulse::printed_collision_matrix(contact, basis).template cast<long double>();
}

template <class S>
[[nodiscard]] Method reflection_in_basis_method() {
  Method method = solver_method<S>(
      {"reflection-in-basis", "reflection in the basis {N, T0, T1} as note §2 prints it", Model::reflection},
      [](const impulse::Contact<S>& contact) { return impulse::reflection_in_basis(contact); });
  method.subject.collision_matrix = printed_matrix<S>;
  return expected_to_fail(std::move(method), "fails near head-on");
}

/// What every scalar type has.
template <class S>
[[nodiscard]] std::vector<Method> scalar_methods() {
  Method adjugate = reflection_method<S, impulse::Adjugate>("reflection-adjugate", "the adjugate");
  if constexpr (precision_of<S> == Precision::binary32) {
    adjugate = expected_to_fail(std::move(adjugate), "the determinant under- and overflows from about 1e±12 kg on");
  }
  return {frictionless_method<S>(), reflection_method<S, impulse::Ldlt>("reflection", "LDLᵀ"),
          reflection_method<S, impulse::EigenLlt>("reflection-llt", "Eigen's LLT"), std::move(adjugate),
          reflection_in_basis_method<S>()};
}

}  // namespace carom::subjects
