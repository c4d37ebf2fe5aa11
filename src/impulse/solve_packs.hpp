// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>

#include <carom/impulse/contact_numbers.hpp>
#include <carom/impulse/pack.hpp>

namespace carom::impulse {

/// Where the arrays begin, in the order of for_each_array. Plain enough to be handed between units that are compiled
/// for different instruction sets.
template <class S>
struct PackTask {
  const S* contacts[contact_number_count];
  S* outcomes[outcome_number_count];
  std::size_t count;
};

/// Takes `law`, Contact<P> → Outcome<P>, over all contacts, a pack P of them at a time. The last ones are filled up
/// with copies of the last. Each pack is read before it is written, so that an array of outcomes may be the array of
/// the velocities that it replaces; otherwise no two arrays overlap.
template <class P, class Law>
void solve_packs(const PackTask<typename P::value_type>& task, const Law& law) {
  constexpr std::experimental::element_aligned_tag unaligned;
  constexpr std::size_t width = P::size();
  std::size_t i = 0;
  for (; i + width <= task.count; i += width) {
    const Outcome<P> outcome = law(contact_of<P>([&](std::size_t k) { return P(task.contacts[k] + i, unaligned); }));
    write_outcome(outcome, [&](std::size_t k, const P& number) { number.copy_to(task.outcomes[k] + i, unaligned); });
  }
  if (i < task.count) {
    const std::size_t last = task.count - 1;
    const Outcome<P> outcome = law(contact_of<P>(
        [&](std::size_t k) { return P([&](auto lane) { return task.contacts[k][std::min(i + lane, last)]; }); }));
    write_outcome(outcome, [&](std::size_t k, const P& number) {
      for (std::size_t lane = 0; i + lane < task.count; ++lane) {
        task.outcomes[k][i + lane] = number[lane];
      }
    });
  }
}

}  // namespace carom::impulse
