// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <carom/collision/law.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/rough.hpp>
#include <carom/impulse/sticking.hpp>

/// The solvers by law. They use LDLᵀ to solve a 3×3 system.
namespace carom::impulse {

namespace detail {

/// The frictionless law. It forms no collision matrix, so it ignores `see` (collision_matrix.hpp).
struct FrictionlessLaw {
  template <class Contact>
  [[nodiscard]] auto operator()(const Contact& contact) const {
    return frictionless_impulse(contact);
  }
  template <class Contact, class S, class... See>
  [[nodiscard]] auto operator()(const Contact& contact, const S& approach, const See&... /*see*/) const {
    return frictionless_impulse(contact, approach);
  }
};

}  // namespace detail

/// Calls use(solver) if the law is one of `laws_with_truth`. `solver` solves a contact in any scalar type, and returns
/// a ContactImpulse or RoughImpulse. Its arguments are the contact, optionally a more accurate N·V⁻, and
/// optionally the function `see`, which receives the collision matrix.
template <class Use>
constexpr void with_law(Law law, const Use& use) {
  switch (law) {
    case Law::frictionless:
      use(detail::FrictionlessLaw());
      return;
    case Law::reflection:
      use([](const auto& contact, const auto&... given) { return reflection_impulse<Ldlt>(contact, given...); });
      return;
    case Law::sticking:
      use([](const auto& contact, const auto&... given) { return sticking_impulse<Ldlt>(contact, given...); });
      return;
    case Law::rough:
      use([](const auto& contact, const auto&... given) { return rough_impulse<Ldlt>(contact, given...); });
      return;
    case Law::coulomb:
    case Law::any:
      return;
  }
}

/// Describes the solver of a law in words.
struct Description {
  std::string_view law;
  std::string_view solve;   // of the 3×3 system; empty if the law has none
  std::string_view source;  // of the formula; empty if the formula is the solver's own
};

[[nodiscard]] constexpr Description description_of(Law law) {
  switch (law) {
    case Law::frictionless:
      return {"impulse along the normal", "", "eq. 18"};
    case Law::reflection:
      return {"basis-free reflection", "LDLᵀ", ""};
    case Law::sticking:
      return {"the tangential relative velocity becomes zero", "LDLᵀ", ""};
    case Law::rough:
      return {"Coulomb friction with tangential restitution", "LDLᵀ", "Chatterjee and Ruina 1998"};
    case Law::coulomb:
      return {"Coulomb friction that opposes the slip after the impulse", "LDLᵀ", ""};
    case Law::any:
      break;
  }
  return {};
}

}  // namespace carom::impulse
