// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <optional>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/oracles/truths/linear_laws.hpp>
#include <carom/oracles/truths/rough.hpp>

/// A type for each law that determines an outcome. docs/internals/adding-a-law.md describes the members of such a type.
namespace carom::oracles {

/// Calls use(type) with an object of the law's type. Throws std::invalid_argument if the law is not one of
/// `laws_with_truth`.
template <class Use>
decltype(auto) with_law(Law law, Use&& use) {
  switch (law) {
    case Law::frictionless:
      return std::forward<Use>(use)(Frictionless{});
    case Law::reflection:
      return std::forward<Use>(use)(Reflection{});
    case Law::sticking:
      return std::forward<Use>(use)(Sticking{});
    case Law::rough:
      return std::forward<Use>(use)(Rough{});
    case Law::coulomb:
    case Law::any:
      break;
  }
  determines_no_outcome(law);
}

/// Calls use(type) with the type by which the law answers on this branch. On the branch `only`, `rough` answers as
/// `frictionless`.
template <class Use>
decltype(auto) with_law(Law law, Branch branch, Use&& use) {
  return with_law(law == Law::rough && branch == Branch::only ? Law::frictionless : law, std::forward<Use>(use));
}

/// The type of a law whose impulse is linear in the change of relative velocity that the law requires. `Rough` combines
/// two such types by a factor κ (rough.hpp) that is not linear.
template <class LawType>
concept LinearLaw = requires {
  &LawType::template wanted_change<double>;
};

/// The laws with a linear type. Their truth is rational.
inline constexpr std::array linear_laws{Law::frictionless, Law::reflection, Law::sticking};

template <class LawType, class T>
[[nodiscard]] Vector3<T> wanted_change(const BasicCollision<T>& c) {
  return LawType::template wanted_change<T>(c.normal, c.restitution, relative_velocity<T>(c, unchanged(c)));
}

namespace detail {

/// The impulses P_I and P_II of the law `rough` (rough.hpp), and D = P_II − P_I.
template <class T>
struct RoughImpulses {
  Vector3<T> stops_approach;
  Vector3<T> stops_point;

  RoughImpulses(const BasicCollision<T>& c, const Matrix3<T>* matrix) {
    CAROM_EXPECTS(has_movable_body(c));
    const Vector3<T> stop = -relative_velocity<T>(c, unchanged(c));
    stops_approach = Rough::StopsApproach::impulse_for<T>(c, stop, matrix);
    stops_point = Rough::StopsPoint::impulse_for<T>(c, stop, matrix);
  }
  [[nodiscard]] Vector3<T> difference() const { return stops_point - stops_approach; }
};

}  // namespace detail

/// The impulse [N s] on A of the law's answer to a contact that collides. `branch` is the branch of the collision, or
/// the branch on the other side of the cone's surface. `matrix` is K, or nullptr if K is not known. T is a field, with
/// square roots if `branch` is `on_cone`. The function does not check the sign of N·V⁻. Precondition: a body is
/// movable.
template <class T>
[[nodiscard]] Vector3<T> colliding_impulse(const BasicCollision<T>& c, Law law, Branch branch,
                                           const Matrix3<T>* matrix = nullptr) {
  CAROM_EXPECTS(has_movable_body(c));
  return with_law(law, branch, [&]<class LawType>(LawType) -> Vector3<T> {
    if constexpr (LinearLaw<LawType>) {
      return LawType::template impulse_for<T>(c, wanted_change<LawType>(c), matrix);
    } else {
      const detail::RoughImpulses<T> of(c, matrix);
      const Vector3<T> d = of.difference();
      return LawType::template combined<T>(c, of.stops_approach, d,
                                           LawType::template friction_share<T>(c, of.stops_approach, d, branch));
    }
  });
}

/// The law's answer to a contact that collides. Parameters and precondition are those of `colliding_impulse`.
template <class T>
[[nodiscard]] Truth<T> colliding_truth(const BasicCollision<T>& c, Law law, Branch branch,
                                       const Matrix3<T>* matrix = nullptr) {
  const Vector3<T> impulse = colliding_impulse<T>(c, law, branch, matrix);
  return {impulse, sum(unchanged(c), response<T>(c, impulse))};
}

template <class T>
[[nodiscard]] Truth<T> truth_of(const BasicCollision<T>& c, Law law, ContactState approach, Branch branch) {
  return approach == ContactState::colliding ? colliding_truth(c, law, branch)
                                             : Truth<T>{{T(0), T(0), T(0)}, unchanged(c)};
}

/// Whether F of `rough` with κ = 1 + e_t (rough.hpp) lies in the friction cone. No value if `sign` does not decide it.
/// `sign` maps a number of type T to −1, 0 or 1, or to no value if the sign is not known. Precondition: a body is
/// movable.
template <class T, class Sign>
[[nodiscard]] std::optional<bool> is_inside_cone(const BasicCollision<T>& c, const Matrix3<T>* matrix,
                                                 const Sign& sign) {
  const detail::RoughImpulses<T> of(c, matrix);
  const auto whole = Rough::whole<T>(c, of.stops_approach, of.difference());
  const std::optional<int> along_normal = sign(whole.along_normal);
  const std::optional<int> slack = sign(whole.slack);
  if (along_normal == -1 || slack == -1) {
    return false;
  }
  return along_normal && slack ? std::optional(true) : std::nullopt;
}

/// Whether some κ > 0 puts F on the cone's surface, so that the formula of `on_cone` has an answer. Parameters and
/// precondition are those of `is_inside_cone`.
template <class T, class Sign>
[[nodiscard]] std::optional<bool> reaches_cone(const BasicCollision<T>& c, const Matrix3<T>* matrix, const Sign& sign) {
  const auto reach = Rough::reach<T>(c, detail::RoughImpulses<T>(c, matrix).difference());
  const std::optional<int> along_normal = sign(reach.along_normal);
  const std::optional<int> beyond = sign(reach.beyond);
  if (along_normal == -1 || beyond == 1) {
    return true;
  }
  return along_normal && beyond ? std::optional(false) : std::nullopt;
}

/// Whether the impulse of the law on this branch may differ from 0 in the limit N·V⁻ → 0. If it does, and rounding of
/// the inputs decides whether the contact collides, two answers are right.
[[nodiscard]] inline bool acts_at_once(Law law, Branch branch) {
  return with_law(law, branch,
                  [&]<class LawType>(LawType) { return LawType::acts_at_once && branch != Branch::on_cone; });
}

}  // namespace carom::oracles
