// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <carom/impulse/batch/solve.hpp>

namespace carom::benchmarks {

/// In double, this many contacts with their outcomes take 36 KB: more than a first-level cache of 32 KiB.
inline constexpr std::size_t in_cache = 64;
/// In double, this many contacts fit into no cache (384 MB).
inline constexpr std::size_t out_of_cache = 1'000'000;

/// The first `count` colliding contacts of a fixed sequence. The greatest moment of a body is at most 4 times its least
/// moment.
[[nodiscard]] std::vector<Collision> colliding(std::size_t count);

/// Like colliding(), but the greatest moment is up to 10⁸ times the least. About half of the bodies are plates or rods.
[[nodiscard]] std::vector<Collision> colliding_slender(std::size_t count);

/// Colliding contacts of needles that are struck on their tips. One of the bodies has moments of up to 1 : 10¹².
[[nodiscard]] std::vector<Collision> colliding_tips(std::size_t count);

/// Colliding contacts of two balls.
[[nodiscard]] std::vector<Collision> colliding_spheres(std::size_t count);

/// A batch of `count` contacts of these collisions. If the collisions are fewer, they repeat.
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

template <class S>
struct Workload {
  explicit Workload(std::size_t count) : contacts(colliding_batch<S>(count)), outcomes(count) {}
  explicit Workload(const std::vector<Collision>& collisions)
      : contacts(batch_of<S>(collisions, collisions.size())), outcomes(collisions.size()) {}

  impulse::ContactBatch<S> contacts;
  impulse::OutcomeBatch<S> outcomes;
};

/// Bytes that a batch solver reads and writes for each contact.
template <class S>
inline constexpr std::size_t bytes_of_contact = (impulse::contact_number_count + impulse::outcome_number_count) *
                                                sizeof(S);

/// Computes z = x + s y for each array z of outcomes. x and y are arrays of contacts.
void triad(Workload<double>& workload);

inline constexpr std::size_t triad_bytes_of_contact = 3 * impulse::outcome_number_count * sizeof(double);

}  // namespace carom::benchmarks
