// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include <carom/impulse/contact.hpp>

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

// The numbers of contacts and outcomes, one by one, in the order of for_each_array.

namespace detail {

/// The index of the first number of each body in a contact.
inline constexpr std::size_t first_number_of_a = 0;
inline constexpr std::size_t first_number_of_b = 22;

/// The body whose numbers are read(first), read(first + 1), ….
template <class S, class Inertia, class Read>
[[nodiscard]] ContactBody<S, Inertia> contact_body_of(const Read& read, std::size_t first) {
  const auto vector = [&](std::size_t k) {
    return Vector3<S>{read(first + k), read(first + k + 1), read(first + k + 2)};
  };
  ContactBody<S, Inertia> body;
  body.inverse_mass = read(first);
  for (int axis = 0; axis < 3; ++axis) {
    body.inertia.axes.col(axis) = vector(1 + 3 * static_cast<std::size_t>(axis));
  }
  body.inertia.inverse_moments = vector(10);
  body.lever_arm = vector(13);
  body.velocity = vector(16);
  body.angular_velocity = vector(19);
  return body;
}

template <class S, class Write>
void write_vector(const Write& write, std::size_t first, const Vector3<S>& vector) {
  write(first, vector[0]);
  write(first + 1, vector[1]);
  write(first + 2, vector[2]);
}

template <class S, class Write>
void write_contact_body(const Write& write, std::size_t first, const ContactBody<S>& body) {
  write(first, body.inverse_mass);
  for (int axis = 0; axis < 3; ++axis) {
    write_vector<S>(write, first + 1 + 3 * static_cast<std::size_t>(axis), body.inertia.axes.col(axis));
  }
  write_vector(write, first + 10, body.inertia.inverse_moments);
  write_vector(write, first + 13, body.lever_arm);
  write_vector(write, first + 16, body.velocity);
  write_vector(write, first + 19, body.angular_velocity);
}

}  // namespace detail

/// The contact whose numbers are read(0), read(1), ….
template <class S, class Inertia = PrincipalInertia<S>, class Read>
[[nodiscard]] Contact<S, Inertia> contact_of(const Read& read) {
  return {detail::contact_body_of<S, Inertia>(read, detail::first_number_of_a),
          detail::contact_body_of<S, Inertia>(read, detail::first_number_of_b),
          Vector3<S>{read(44), read(45), read(46)},
          read(47),
          read(48),
          read(49)};
}

/// Calls write(k, number) for each number of a contact.
template <class S, class Write>
void write_contact(const Contact<S>& contact, const Write& write) {
  detail::write_contact_body(write, detail::first_number_of_a, contact.a);
  detail::write_contact_body(write, detail::first_number_of_b, contact.b);
  detail::write_vector(write, 44, contact.normal);
  write(47, contact.restitution);
  write(48, contact.friction);
  write(49, contact.tangential_restitution);
}

/// The outcome whose numbers are read(0), read(1), ….
template <class S, class Read>
[[nodiscard]] Outcome<S> outcome_of(const Read& read) {
  const auto vector = [&](std::size_t k) { return Vector3<S>{read(k), read(k + 1), read(k + 2)}; };
  return {{vector(0), vector(3)}, {vector(6), vector(9)}};
}

/// Calls write(k, number) for each number of an outcome.
template <class S, class Write>
void write_outcome(const Outcome<S>& outcome, const Write& write) {
  detail::write_vector(write, 0, outcome.a.velocity);
  detail::write_vector(write, 3, outcome.a.angular_velocity);
  detail::write_vector(write, 6, outcome.b.velocity);
  detail::write_vector(write, 9, outcome.b.angular_velocity);
}

/// Pointers to the beginnings of the arrays, in the order of for_each_array. Units of different instruction sets share
/// this type.
template <class S>
struct PackTask {
  const S* contacts[contact_number_count];
  S* outcomes[outcome_number_count];
  std::size_t count;
};

}  // namespace carom::impulse
