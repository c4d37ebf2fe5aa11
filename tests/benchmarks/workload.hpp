// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <carom/impulse/batch/solve.hpp>

/// What is measured, and over what.
namespace carom::benchmarks {

/// Contacts that fit the first cache with their outcomes, in double.
inline constexpr std::size_t in_cache = 64;
/// Contacts that no cache holds: 384 MB in double.
inline constexpr std::size_t out_of_cache = 1'000'000;

/// Colliding contacts of general bodies, moments to 1 : 4, the first of a fixed sequence.
[[nodiscard]] std::vector<Collision> colliding(std::size_t count);

/// The same of bodies of which about half are plates or rods, moments to 1 : 10⁸.
[[nodiscard]] std::vector<Collision> colliding_slender(std::size_t count);

/// Collisions as a batch; where there are fewer they repeat.
template <class S>
[[nodiscard]] impulse::ContactBatch<S> batch_of(const std::vector<Collision>& collisions, std::size_t count) {
  std::vector<impulse::Contact<S>> contacts;
  for (std::size_t i = 0; i < count && i < collisions.size(); ++i) {
    contacts.push_back(impulse::make_contact<S>(collisions[i]));
  }
  impulse::ContactBatch<S> batch(count);
  for (std::size_t i = 0; i < count; ++i) {
    batch.set(i, contacts[i % contacts.size()]);
  }
  return batch;
}

template <class S>
[[nodiscard]] impulse::ContactBatch<S> colliding_batch(std::size_t count) {
  static const std::vector<Collision> collisions = colliding(4096);
  return batch_of<S>(collisions, count);
}

/// Contacts and where their outcomes go.
template <class S>
struct Workload {
  explicit Workload(std::size_t count) : contacts(colliding_batch<S>(count)), outcomes(count) {}
  explicit Workload(const std::vector<Collision>& collisions)
      : contacts(batch_of<S>(collisions, collisions.size())), outcomes(collisions.size()) {}

  impulse::ContactBatch<S> contacts;
  impulse::OutcomeBatch<S> outcomes;
};

/// Bytes that a batch solver reads and writes for a contact.
template <class S>
inline constexpr std::size_t bytes_of_contact = (impulse::contact_number_count + impulse::outcome_number_count) *
                                                sizeof(S);

/// The plain triad z = x + s y over the arrays of a workload, one triple of arrays after the other: each of the arrays
/// of outcomes from two of the arrays of contacts.
void triad(Workload<double>& workload);

/// Bytes that the triad reads and writes for a contact.
inline constexpr std::size_t triad_bytes_of_contact = 3 * impulse::outcome_number_count * sizeof(double);

}  // namespace carom::benchmarks
