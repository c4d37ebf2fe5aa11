// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>

#include <carom/oracles/models/frictionless.hpp>
#include <carom/oracles/models/reflection.hpp>
#include <carom/oracles/models/sticking.hpp>

/// The models that determine an outcome, a type each. None of what these types say is trusted: a truth is certified by
/// the defining equations, and the rest is held against it in the tests.
namespace carom::oracles {

/// use(law), law being an object of the type that stands for the model. Throws std::invalid_argument where the model is
/// not one of `models_with_truth`.
template <class Use>
decltype(auto) with_law(Model model, Use&& use) {
  switch (model) {
    case Model::frictionless:
      return std::forward<Use>(use)(Frictionless{});
    case Model::reflection:
      return std::forward<Use>(use)(Reflection{});
    case Model::sticking:
      return std::forward<Use>(use)(Sticking{});
    case Model::any:
      break;
  }
  determines_no_outcome(model);
}

/// The change of relative velocity that the law asks for.
template <class T>
[[nodiscard]] Vector3<T> wanted_change(const BasicCollision<T>& c, Model model) {
  return with_law(model, [&]<class Law>(Law) {
    return Law::template wanted_change<T>(c.normal, c.restitution, relative_velocity<T>(c, unchanged(c)));
  });
}

/// The impulse on A by which the law brings about what it asks for of a change of relative velocity. Linear in the
/// change. `matrix` is the response matrix where it is known already. Precondition: a body is movable.
template <class T>
[[nodiscard]] Vector3<T> impulse_for(const BasicCollision<T>& c, Model model, const Vector3<T>& change,
                                     const Matrix3<T>* matrix = nullptr) {
  return with_law(model, [&]<class Law>(Law) { return Law::template impulse_for<T>(c, change, matrix); });
}

/// The law's answer to a contact that collides. T is a field; the sign of N·V⁻ is not asked. Precondition: a body is
/// movable.
template <class T>
[[nodiscard]] Truth<T> colliding_truth(const BasicCollision<T>& c, Model model) {
  const Vector3<T> impulse = impulse_for<T>(c, model, wanted_change(c, model));
  return {impulse, sum(unchanged(c), response<T>(c, impulse))};
}

/// The law's answer to a contact with this approach.
template <class T>
[[nodiscard]] Truth<T> truth_of(const BasicCollision<T>& c, Model model, Approach approach) {
  return approach == Approach::colliding ? colliding_truth(c, model) : Truth<T>{{T(0), T(0), T(0)}, unchanged(c)};
}

/// The equations that the answer of every model satisfies to every contact that they speak of: `restitution` where it
/// collides, `untouched` where it does not and of immovable bodies.
inline constexpr std::array kept_by_every_model{
    AffineEquation::linear_momentum,       AffineEquation::angular_momentum_of_a,
    AffineEquation::angular_momentum_of_b, AffineEquation::total_angular_momentum,
    AffineEquation::restitution,           AffineEquation::non_penetration,
    AffineEquation::untouched_a,           AffineEquation::untouched_b};

namespace detail {

template <class Law>
[[nodiscard]] constexpr PerAffineEquation<bool> kept_equations() {
  PerAffineEquation<bool> kept{};
  for (const AffineEquation equation : kept_by_every_model) {
    kept[equation] = true;
  }
  for (const AffineEquation equation : Law::keeps) {
    kept[equation] = true;
  }
  return kept;
}

template <class Law>
inline constexpr PerAffineEquation<bool> kept_equations_of = kept_equations<Law>();

}  // namespace detail

/// Whether the answer of the model satisfies the equation to every contact that it speaks of.
[[nodiscard]] inline bool keeps(Model model, AffineEquation equation) {
  return with_law(model, [&]<class Law>(Law) { return detail::kept_equations_of<Law>[equation]; });
}

/// Whether the impulse of the model does not vanish with N·V⁻. Where inputs within rounding include both colliding and
/// separating contacts, its answers to both are then open to an outcome, and neither is asked of it alone.
[[nodiscard]] inline bool acts_at_once(Model model) {
  return with_law(model, []<class Law>(Law) { return Law::acts_at_once; });
}

/// Whether the answer of the model never has more energy than before, beside the work of a driven wall.
[[nodiscard]] inline bool creates_no_energy(Model model) {
  return with_law(model, []<class Law>(Law) { return Law::creates_no_energy; });
}

}  // namespace carom::oracles
