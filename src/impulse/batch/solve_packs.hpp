// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <carom/impulse/batch/contact_arrays.hpp>
#include <carom/impulse/contact_impulse.hpp>
#include <carom/impulse/numbers/pack.hpp>
#include <carom/impulse/principal_inertia.hpp>
#include <carom/impulse/select.hpp>

namespace carom::impulse {

namespace detail {

/// Prefetches the next block of every array into the second-level cache. The processor's prefetcher cannot follow so
/// many arrays, and would lose a third of the bandwidth.
template <class S>
class BlockPrefetch {
 public:
  explicit BlockPrefetch(const PackTask<S>& task) : task_(task) {}

  /// Whether the arrays are too large for a second-level cache of usual size, 1 MiB.
  [[nodiscard]] bool pays() const {
    return task_.count * (contact_number_count + outcome_number_count) * sizeof(S) > std::size_t{1} << 20;
  }

  /// Prefetches a share of the next block, while the contacts from i to i + width are solved. Inlining is forced
  /// because gcc drops a call that only prefetches.
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
      // The address is an integer, because the last block may end beyond the array.
      const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(begin) + next * sizeof(S) + k % lines * line;
      __builtin_prefetch(reinterpret_cast<const void*>(address), 0, 2);
    }
  }

 private:
  static constexpr std::size_t line = 64;   // bytes
  static constexpr std::size_t lines = 32;  // cache lines of each array in a block: half a page
  static constexpr std::size_t arrays = contact_number_count + outcome_number_count;
  static constexpr std::size_t block = lines * line / sizeof(S);

  const PackTask<S>& task_;
};

constexpr std::experimental::element_aligned_tag unaligned;

/// The pack of the k-th numbers of the contacts from i on.
template <class P>
[[nodiscard]] P read_pack(const PackTask<typename P::value_type>& task, std::size_t k, std::size_t i) {
  return P(task.contacts[k] + i, unaligned);
}

/// A function that writes the pack of the k-th numbers of the outcomes from i on.
template <class P>
[[nodiscard]] auto writer(const PackTask<typename P::value_type>& task, std::size_t i) {
  return [&task, i](std::size_t k, const P& number) { number.copy_to(task.outcomes[k] + i, unaligned); };
}

/// Solves the pack of contacts from i on.
template <class P, class Inertia, class Solver>
void solve_as(const PackTask<typename P::value_type>& task, std::size_t i, const Solver& solver) {
  const Contact<P, Inertia> contact = contact_of<P, Inertia>([&](std::size_t k) { return read_pack<P>(task, k, i); });
  write_outcome(apply_impulse(contact, solver(contact)), writer<P>(task, i));
}

/// Solves a pack with slender bodies. Not inlined, so that it takes no registers from the usual case. Each instruction
/// set has its own type P, so the linker uses this function in no other unit.
template <class P, class Solver>
[[gnu::noinline, gnu::flatten]] void solve_slender(const PackTask<typename P::value_type>& task, std::size_t i,
                                                   const Solver& solver) {
  solve_as<P, PrincipalInertia<P>>(task, i, solver);
}

/// The knowledge of the moments of both bodies that holds in every lane.
template <class P>
[[nodiscard]] Moments moments_of_pack(const PackTask<typename P::value_type>& task, std::size_t i) {
  bool is_any_slender = false;
  bool is_every_isotropic = true;
  for (const std::size_t first : {first_number_of_a, first_number_of_b}) {
    const auto body =
        contact_body_of<P, PrincipalInertia<P>>([&](std::size_t k) { return read_pack<P>(task, k, i); }, first);
    is_any_slender = is_any_slender || !none_of(is_slender(body.inertia));
    is_every_isotropic = is_every_isotropic && all_of(is_isotropic(body.inertia));
  }
  if (is_any_slender) {
    return Moments::any;
  }
  return is_every_isotropic ? Moments::equal : Moments::not_slender;
}

/// Solves the pack of contacts from i on. If no body is slender, it takes a faster type of inertia, and the fastest if
/// the moments of each body are equal. Finite numbers give the same bits by each type. A solver that accepts only
/// PrincipalInertia<P> gets this type.
template <class P, class Solver>
void solve_pack(const PackTask<typename P::value_type>& task, std::size_t i, const Solver& solver) {
  using NotSlender = PrincipalInertia<P, Moments::not_slender>;
  if constexpr (std::is_invocable_v<const Solver&, const Contact<P, NotSlender>&>) {
    switch (moments_of_pack<P>(task, i)) {
      case Moments::not_slender:
        solve_as<P, NotSlender>(task, i, solver);
        return;
      case Moments::equal:
        solve_as<P, PrincipalInertia<P, Moments::equal>>(task, i, solver);
        return;
      case Moments::any:
        break;
    }
  }
  solve_slender<P>(task, i, solver);
}

/// Solves all full packs, and returns the number of contacts in them.
template <class P, class Solver>
[[gnu::noinline, gnu::flatten]] std::size_t solve_full_packs(const PackTask<typename P::value_type>& task,
                                                             const Solver& solver) {
  constexpr std::size_t width = P::size();
  const BlockPrefetch prefetch(task);
  const bool is_large = prefetch.pays();
  std::size_t i = 0;
  for (; i + width <= task.count; i += width) {
    if (is_large) {
      prefetch.ask(i, width);
    }
    solve_pack<P>(task, i, solver);
  }
  return i;
}

template <class P>
struct OnePack {
  using S = typename P::value_type;

  /// Copies the remaining contacts from i on, and fills the pack with copies of the last contact.
  OnePack(const PackTask<S>& task, std::size_t i) {
    for (std::size_t k = 0; k < contact_number_count; ++k) {
      for (std::size_t lane = 0; lane < P::size(); ++lane) {
        contacts[k][lane] = task.contacts[k][i + lane < task.count ? i + lane : task.count - 1];
      }
    }
  }
  [[nodiscard]] PackTask<S> task() {
    PackTask<S> result;
    for (std::size_t k = 0; k < contact_number_count; ++k) {
      result.contacts[k] = contacts[k];
    }
    for (std::size_t k = 0; k < outcome_number_count; ++k) {
      result.outcomes[k] = outcomes[k];
    }
    result.count = P::size();
    return result;
  }
  void write_to(const PackTask<S>& task, std::size_t i) const {
    for (std::size_t k = 0; k < outcome_number_count; ++k) {
      for (std::size_t lane = 0; i + lane < task.count; ++lane) {
        task.outcomes[k][i + lane] = outcomes[k][lane];
      }
    }
  }

  S contacts[contact_number_count][P::size()];
  S outcomes[outcome_number_count][P::size()];
};

}  // namespace detail

/// Applies `solver` to all contacts. `solver` maps a Contact<P> to a ContactImpulse<P> or a RoughImpulse<P>. An array
/// of outcomes may be the array of the contacts' velocities that it replaces. Otherwise no two arrays overlap.
template <class P, class Solver>
void solve_packs(const PackTask<typename P::value_type>& task, const Solver& solver) {
  const std::size_t solved = detail::solve_full_packs<P>(task, solver);
  if (solved < task.count) {
    detail::OnePack<P> rest(task, solved);
    detail::solve_full_packs<P>(rest.task(), solver);
    rest.write_to(task, solved);
  }
}

}  // namespace carom::impulse
