// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

/// Contacts and outcomes as structures of arrays, one array for each scalar component. The caller owns the memory. The
/// arrays of one structure have the same length, and need no alignment. T is S or const S.
namespace carom::impulse {

template <class T>
using VectorArrays = std::array<std::span<T>, 3>;

/// Arrays of the members of ContactBody<S> (contact.hpp).
template <class T>
struct ContactBodyArrays {
  std::span<T> inverse_mass;
  std::array<VectorArrays<T>, 3> axes;  // the first, second and third body axis, as in PrincipalInertia<S>
  VectorArrays<T> inverse_moments;
  VectorArrays<T> lever_arm;
  VectorArrays<T> velocity;
  VectorArrays<T> angular_velocity;
};

/// Arrays of the members of Contact<S> (contact.hpp).
template <class T>
struct ContactArrays {
  ContactBodyArrays<T> a;
  ContactBodyArrays<T> b;
  VectorArrays<T> normal;
  std::span<T> restitution;
  std::span<T> friction;
  std::span<T> tangential_restitution;

  [[nodiscard]] std::size_t size() const { return restitution.size(); }
};

template <class T>
struct BodyVelocityArrays {
  VectorArrays<T> velocity;
  VectorArrays<T> angular_velocity;
};

/// Arrays of the members of Outcome<S>.
template <class T>
struct OutcomeArrays {
  BodyVelocityArrays<T> a;
  BodyVelocityArrays<T> b;

  [[nodiscard]] std::size_t size() const { return a.velocity[0].size(); }
};

/// The number of arrays of a contact and of an outcome.
inline constexpr std::size_t contact_number_count = 50;
inline constexpr std::size_t outcome_number_count = 12;

namespace detail {

template <class Arrays, class F>
void for_each_of(Arrays& arrays, F& f) {
  for (auto& array : arrays) {
    f(array);
  }
}

template <class Arrays, class F>
void for_each_of_body(Arrays& body, F& f) {
  f(body.inverse_mass);
  for (auto& axis : body.axes) {
    for_each_of(axis, f);
  }
  for_each_of(body.inverse_moments, f);
  for_each_of(body.lever_arm, f);
  for_each_of(body.velocity, f);
  for_each_of(body.angular_velocity, f);
}

}  // namespace detail

/// Calls f(span) for every array of the structure, in declaration order.
template <class T, class F>
void for_each_array(ContactArrays<T>& contacts, F&& f) {
  detail::for_each_of_body(contacts.a, f);
  detail::for_each_of_body(contacts.b, f);
  detail::for_each_of(contacts.normal, f);
  f(contacts.restitution);
  f(contacts.friction);
  f(contacts.tangential_restitution);
}

template <class T, class F>
void for_each_array(OutcomeArrays<T>& outcomes, F&& f) {
  for (BodyVelocityArrays<T>* body : {&outcomes.a, &outcomes.b}) {
    detail::for_each_of(body->velocity, f);
    detail::for_each_of(body->angular_velocity, f);
  }
}

template <class S>
[[nodiscard]] ContactArrays<const S> read_only(ContactArrays<S> contacts) {
  std::array<std::span<const S>, contact_number_count> spans;
  std::size_t k = 0;
  for_each_array(contacts, [&](const std::span<S>& array) { spans[k++] = array; });
  ContactArrays<const S> result;
  k = 0;
  for_each_array(result, [&](std::span<const S>& array) { array = spans[k++]; });
  return result;
}

}  // namespace carom::impulse
