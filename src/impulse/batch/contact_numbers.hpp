// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>

#include <carom/impulse/batch/contact_arrays.hpp>
#include <carom/impulse/contact.hpp>

/// The numbers of contacts and outcomes, one by one, in the order of for_each_array (contact_arrays.hpp).
namespace carom::impulse {

namespace detail {

/// The index of the first number of each body in a contact, and in an outcome.
inline constexpr std::size_t first_number_of_a = 0;
inline constexpr std::size_t first_number_of_b = 22;
inline constexpr std::size_t first_outcome_of_a = 0;
inline constexpr std::size_t first_outcome_of_b = 6;

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

template <class S, class Write>
void write_body_velocity(const BodyVelocity<S>& body, std::size_t first, const Write& write) {
  write_vector(write, first, body.velocity);
  write_vector(write, first + 3, body.angular_velocity);
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
  detail::write_body_velocity(outcome.a, detail::first_outcome_of_a, write);
  detail::write_body_velocity(outcome.b, detail::first_outcome_of_b, write);
}

}  // namespace carom::impulse
