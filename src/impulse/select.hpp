// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include <carom/collision/outcome.hpp>

/// Choices by a condition: a bool for a scalar, or a mask with one bool for each lane of a pack.
namespace carom::impulse {

/// Whether the condition holds in no lane. For masks, argument-dependent lookup finds std::experimental::none_of.
[[nodiscard]] inline bool none_of(bool condition) { return !condition; }

/// Whether the condition is a bool and false. A law returns early only if it is, because gcc keeps packs in memory
/// across a branch.
template <class Condition>
[[nodiscard]] bool is_known_false(const Condition& condition) {
  if constexpr (std::is_same_v<Condition, bool>) {
    return !condition;
  } else {
    return false;
  }
}

/// `yes` if the condition holds, otherwise `no`, lane by lane.
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

/// The number, or `least` if the number is below it. A NaN stays.
template <class S>
[[nodiscard]] S at_least(const S& least, const S& number) {
  if constexpr (std::is_same_v<decltype(number < least), bool>) {
    return number < least ? least : number;
  } else {
    // A selection by a mask would have three times the latency.
    using Numbers [[gnu::vector_size(sizeof(S))]] = typename S::value_type;
    const auto numbers = std::bit_cast<Numbers>(number);
    const auto leasts = std::bit_cast<Numbers>(least);
    return std::bit_cast<S>(leasts > numbers ? leasts : numbers);
  }
}

template <class S>
[[nodiscard]] S absolute(const S& x) {
  if constexpr (std::is_floating_point_v<S>) {
    return std::abs(x);
  } else {
    return at_least(S(-x), x);
  }
}

/// max |v_i|. A NaN in v₀ or v₁ may be lost.
template <class S>
[[nodiscard]] S greatest_size(const Vector3<S>& v) {
  return at_least(at_least(absolute(v[0]), absolute(v[1])), absolute(v[2]));
}

/// The unit roundoff of a floating-point type, or of the lanes of a pack. 0 for every other type.
template <class S>
[[nodiscard]] constexpr auto unit_roundoff() {
  if constexpr (std::is_floating_point_v<S>) {
    return std::numeric_limits<S>::epsilon() / 2;
  } else if constexpr (requires { typename S::value_type; }) {
    return std::numeric_limits<typename S::value_type>::epsilon() / 2;
  } else {
    return 0;
  }
}

/// x, or the least positive normal number if x is below this number. The number belongs to S if S is a floating-point
/// type, to a lane if S is a pack, and otherwise to binary64.
template <class S>
[[nodiscard]] S at_least_normal(const S& x) {
  const auto least = [] {
    if constexpr (std::is_floating_point_v<S>) {
      return std::numeric_limits<S>::min();
    } else if constexpr (requires { typename S::value_type; }) {
      return std::numeric_limits<typename S::value_type>::min();
    } else {
      return std::numeric_limits<double>::min();
    }
  }();
  return at_least(S(least), x);
}

/// 1 / at_least_normal(x), which is finite.
template <class S>
[[nodiscard]] S finite_reciprocal(const S& x) {
  return S(1) / at_least_normal(x);
}

template <class Condition, class S>
[[nodiscard]] Vector3<S> select(const Condition& condition, const Vector3<S>& yes, const Vector3<S>& no) {
  return {select(condition, yes[0], no[0]), select(condition, yes[1], no[1]), select(condition, yes[2], no[2])};
}

template <class Condition, class S>
[[nodiscard]] Matrix3<S> select(const Condition& condition, const Matrix3<S>& yes, const Matrix3<S>& no) {
  Matrix3<S> chosen;
  for (int column = 0; column < 3; ++column) {
    chosen.col(column) = select<Condition, S>(condition, Vector3<S>(yes.col(column)), Vector3<S>(no.col(column)));
  }
  return chosen;
}

template <class Condition, class S>
[[nodiscard]] BodyVelocity<S> select(const Condition& condition, const BodyVelocity<S>& yes,
                                     const BodyVelocity<S>& no) {
  return {select(condition, yes.velocity, no.velocity), select(condition, yes.angular_velocity, no.angular_velocity)};
}

/// Chooses between the results of yes() and no(), if they take long. For a bool, calls only the chosen function. For a
/// mask, calls yes() if any lane chooses it, and no() if any lane chooses no().
template <class Condition, class Yes, class No>
[[nodiscard]] auto select_called(const Condition& condition, const Yes& yes, const No& no) {
  if constexpr (std::is_same_v<Condition, bool>) {
    return condition ? yes() : no();
  } else {
    if (all_of(condition)) [[unlikely]] {
      return yes();
    }
    auto chosen = no();
    if (!none_of(condition)) [[unlikely]] {
      chosen = select(condition, yes(), chosen);
    }
    return chosen;
  }
}

}  // namespace carom::impulse
