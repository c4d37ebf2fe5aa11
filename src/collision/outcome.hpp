// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string_view>

#include <carom/collision/collision.hpp>
#include <carom/collision/enum_array.hpp>

namespace carom {

template <class S>
struct BodyVelocity {
  Vector3<S> velocity{S{0}, S{0}, S{0}};          // of the centre of mass, world [m/s]
  Vector3<S> angular_velocity{S{0}, S{0}, S{0}};  // world [rad/s]
};

/// The velocities of both bodies after the impulse.
template <class S>
struct Outcome {
  BodyVelocity<S> a;
  BodyVelocity<S> b;
};

enum class OutcomeVector { velocity_of_a, angular_velocity_of_a, velocity_of_b, angular_velocity_of_b };

inline constexpr std::array all_outcome_vectors{OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a,
                                                OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b};
static_assert(counts_from_zero_to(all_outcome_vectors, OutcomeVector::angular_velocity_of_b));

template <class T>
using PerVector = EnumArray<OutcomeVector, T, all_outcome_vectors.size()>;

/// The name of the vector in the line protocol.
[[nodiscard]] constexpr std::string_view name_of(OutcomeVector vector) {
  constexpr PerVector<std::string_view> names{"a.velocity", "a.angular_velocity", "b.velocity", "b.angular_velocity"};
  return names[vector];
}

/// The velocity and the angular velocity of A or of B.
[[nodiscard]] constexpr std::array<OutcomeVector, 2> vectors_of_body(bool a) {
  return a ? std::array{OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a}
           : std::array{OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b};
}

template <class S>
[[nodiscard]] PerVector<Vector3<S>*> vectors(Outcome<S>& outcome) {
  return {&outcome.a.velocity, &outcome.a.angular_velocity, &outcome.b.velocity, &outcome.b.angular_velocity};
}

template <class S>
[[nodiscard]] PerVector<const Vector3<S>*> vectors(const Outcome<S>& outcome) {
  return {&outcome.a.velocity, &outcome.a.angular_velocity, &outcome.b.velocity, &outcome.b.angular_velocity};
}

/// The same outcome in another scalar type: each number x becomes convert(x).
template <class T, class S, class Convert>
[[nodiscard]] Outcome<T> map_outcome(const Outcome<S>& outcome, Convert&& convert) {
  Outcome<T> mapped;
  const auto from = vectors(outcome);
  const auto to = vectors(mapped);
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      (*to[k])[i] = convert((*from[k])[i]);
    }
  }
  return mapped;
}

/// The velocities before the impulse: the correct outcome if the contact is not colliding.
template <class S>
[[nodiscard]] Outcome<S> unchanged(const BasicCollision<S>& collision) {
  return {{collision.a.velocity, collision.a.angular_velocity}, {collision.b.velocity, collision.b.angular_velocity}};
}

/// The collision with the outcome's velocities in place of its own.
template <class S>
[[nodiscard]] BasicCollision<S> with_velocities(BasicCollision<S> collision, const Outcome<S>& outcome) {
  collision.a.velocity = outcome.a.velocity;
  collision.a.angular_velocity = outcome.a.angular_velocity;
  collision.b.velocity = outcome.b.velocity;
  collision.b.angular_velocity = outcome.b.angular_velocity;
  return collision;
}

}  // namespace carom
