// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <carom/impulse/batch/contact_numbers.hpp>
#include <carom/impulse/batch/pack_task.hpp>
#include <carom/impulse/numbers/pack.hpp>

namespace carom::impulse {

namespace detail {

/// Asks for a block of all arrays while the block before it is solved, one array after the other, into the second
/// cache. So many arrays read side by side are more than a machine foresees: without this a third of the bandwidth is
/// lost.
template <class S>
class BlockPrefetch {
 public:
  explicit BlockPrefetch(const PackTask<S>& task) : task_(task) {}

  /// Whether the task is large enough that its arrays come from beyond a second cache of usual size, 1 MiB.
  [[nodiscard]] bool pays() const {
    return task_.count * (contact_number_count + outcome_number_count) * sizeof(S) > std::size_t{1} << 20;
  }

  /// The share of the next block that falls to the contacts from i to i + width. Inlined by order: gcc takes a function
  /// that only prefetches for one without effect, and drops the call.
  [[gnu::always_inline]] void ask(std::size_t i, std::size_t width) const {
    const std::size_t next = (i / block + 1) * block;
    if (next >= task_.count) {
      return;
    }
    const std::size_t share = width * lines * arrays / block;
    const std::size_t first = i % block / width * share;
    for (std::size_t k = first; k < first + share; ++k) {
      const std::size_t array = k / lines;
      const void* begin = array < contact_number_count
                              ? static_cast<const void*>(task_.contacts[array])
                              : static_cast<const void*>(task_.outcomes[array - contact_number_count]);
      // As a number: the last block may end beyond the array, which does no harm in a prefetch.
      const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(begin) + next * sizeof(S) + k % lines * line;
      __builtin_prefetch(reinterpret_cast<const void*>(address), 0, 2);
    }
  }

 private:
  static constexpr std::size_t line = 64;   // bytes
  static constexpr std::size_t lines = 32;  // of each array in a block: half a page
  static constexpr std::size_t arrays = contact_number_count + outcome_number_count;
  static constexpr std::size_t block = lines * line / sizeof(S);

  const PackTask<S>& task_;
};

}  // namespace detail

/// Takes `law`, Contact<P> → Outcome<P>, over all contacts, a pack P of them at a time. The last ones are filled up
/// with copies of the last. Each pack is read before it is written, so that an array of outcomes may be the array of
/// the velocities that it replaces; otherwise no two arrays overlap.
template <class P, class Law>
void solve_packs(const PackTask<typename P::value_type>& task, const Law& law) {
  constexpr std::experimental::element_aligned_tag unaligned;
  constexpr std::size_t width = P::size();
  const detail::BlockPrefetch prefetch(task);
  const bool is_large = prefetch.pays();
  std::size_t i = 0;
  for (; i + width <= task.count; i += width) {
    if (is_large) {
      prefetch.ask(i, width);
    }
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
