// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <type_traits>

#include <carom/collision/outcome.hpp>

/// Choices by a condition that is one bool for a scalar, and a mask with one bool a lane for a pack of numbers.
namespace carom::impulse {

/// Whether the condition holds nowhere. For masks std::experimental::none_of is found by its argument.
[[nodiscard]] inline bool none_of(bool condition) { return !condition; }

/// `yes` where the condition holds, `no` elsewhere, lane by lane.
template <class Condition, class S>
[[nodiscard]] S select(const Condition& condition, const S& yes, const S& no) {
  if constexpr (std::is_same_v<Condition, bool>) {
    return condition ? yes : no;
  } else {
    S chosen = no;
    where(condition, chosen) = yes;
    return chosen;
  }
}

template <class Condition, class S>
[[nodiscard]] Vector3<S> select(const Condition& condition, const Vector3<S>& yes, const Vector3<S>& no) {
  return {select(condition, yes[0], no[0]), select(condition, yes[1], no[1]), select(condition, yes[2], no[2])};
}

template <class Condition, class S>
[[nodiscard]] BodyVelocity<S> select(const Condition& condition, const BodyVelocity<S>& yes,
                                     const BodyVelocity<S>& no) {
  return {select(condition, yes.velocity, no.velocity), select(condition, yes.angular_velocity, no.angular_velocity)};
}

template <class Condition, class S>
[[nodiscard]] Outcome<S> select(const Condition& condition, const Outcome<S>& yes, const Outcome<S>& no) {
  return {select(condition, yes.a, no.a), select(condition, yes.b, no.b)};
}

}  // namespace carom::impulse
