// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <carom/impulse/batch/contact_numbers.hpp>
#include <carom/impulse/batch/pack_task.hpp>
#include <carom/impulse/contact_impulse.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/numbers/pack.hpp>
#include <carom/impulse/rough.hpp>

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

}  // namespace detail

namespace detail {

constexpr std::experimental::element_aligned_tag unaligned;

/// The pack of the k-th numbers of the contacts from i on.
template <class P>
[[nodiscard]] P read_pack(const PackTask<typename P::value_type>& task, std::size_t k, std::size_t i) {
  return P(task.contacts[k] + i, unaligned);
}

template <class P, class Inertia = PrincipalInertia<P>>
[[nodiscard]] Contact<P, Inertia> read_contact(const PackTask<typename P::value_type>& task, std::size_t i) {
  return contact_of<P, Inertia>([&](std::size_t k) { return read_pack<P>(task, k, i); });
}

/// A function that writes the pack of the k-th numbers of the outcomes from i on.
template <class P>
[[nodiscard]] auto writer(const PackTask<typename P::value_type>& task, std::size_t i) {
  return [&task, i](std::size_t k, const P& number) { number.copy_to(task.outcomes[k] + i, unaligned); };
}

/// Writes the outcome of a pack. Reading each body again is faster than keeping it.
template <class P, class Inertia>
void write_outcome_of(const PackTask<typename P::value_type>& task, std::size_t i, const ContactImpulse<P>& impulse) {
  const auto is_any_slender = has_slender(read_contact<P, Inertia>(task, i));
  const auto solve_body = [&](std::size_t first, std::size_t first_of_outcome, const Vector3<P>& on_body) {
    const auto body = contact_body_of<P, Inertia>([&](std::size_t k) { return read_pack<P>(task, k, i); }, first);
    write_body_velocity<P>(apply_impulse(impulse.colliding, body, on_body, is_any_slender), first_of_outcome,
                           writer<P>(task, i));
  };
  solve_body(first_number_of_a, first_outcome_of_a, impulse.on_a);
  solve_body(first_number_of_b, first_outcome_of_b, -impulse.on_a);
}

template <class P, class Inertia>
void write_outcome_of(const PackTask<typename P::value_type>& task, std::size_t i, const NormalImpulse<P>& impulse) {
  write_outcome(apply_impulse(read_contact<P, Inertia>(task, i), impulse), writer<P>(task, i));
}

template <class P, class Inertia>
void write_outcome_of(const PackTask<typename P::value_type>& task, std::size_t i, const RoughImpulse<P>& impulse) {
  write_outcome(apply_impulse(read_contact<P, Inertia>(task, i), impulse), writer<P>(task, i));
}

template <class P, class Inertia>
void write_outcome_of(const PackTask<typename P::value_type>& task, std::size_t i, const Outcome<P>& outcome) {
  write_outcome(outcome, writer<P>(task, i));
}

/// Solves `Packs` packs of contacts from i on. Computes the impulses of all packs before it writes an outcome. Each
/// impulse is a long chain of dependent operations, and the processor interleaves the chains.
template <class P, class Inertia, std::size_t Packs, class Solver>
void solve_as(const PackTask<typename P::value_type>& task, std::size_t i, const Solver& solver) {
  std::array<std::invoke_result_t<const Solver&, const Contact<P, Inertia>&>, Packs> answers;
#pragma GCC unroll 2
  for (std::size_t pack = 0; pack < Packs; ++pack) {
    answers[pack] = solver(read_contact<P, Inertia>(task, i + pack * P::size()));
  }
#pragma GCC unroll 2
  for (std::size_t pack = 0; pack < Packs; ++pack) {
    write_outcome_of<P, Inertia>(task, i + pack * P::size(), answers[pack]);
  }
}

/// Solves one pack with slender bodies. Not inlined, so that it takes no registers from the usual case. Each
/// instruction set has its own type P, so the linker uses this function in no other unit.
template <class P, class Solver>
[[gnu::noinline, gnu::flatten]] void solve_slender(const PackTask<typename P::value_type>& task, std::size_t i,
                                                   const Solver& solver) {
  solve_as<P, PrincipalInertia<P>, 1>(task, i, solver);
}

/// Solves contacts with the faster type PrincipalInertia<P, false> if no body is slender and the solver accepts this
/// type.
template <class P, std::size_t Packs, class Solver>
void solve_from(const PackTask<typename P::value_type>& task, std::size_t i, const Solver& solver) {
  using NotSlender = PrincipalInertia<P, false>;
  if constexpr (std::is_invocable_v<const Solver&, const Contact<P, NotSlender>&>) {
    bool is_any_slender = false;
#pragma GCC unroll 2
    for (std::size_t pack = 0; pack < Packs; ++pack) {
      is_any_slender = is_any_slender || !none_of(has_slender(read_contact<P>(task, i + pack * P::size())));
    }
    if (!is_any_slender) {
      solve_as<P, NotSlender, Packs>(task, i, solver);
      return;
    }
  }
  for (std::size_t pack = 0; pack < Packs; ++pack) {
    solve_slender<P>(task, i + pack * P::size(), solver);
  }
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

/// Applies `solver` to all contacts. `solver` maps a Contact<P> to a ContactImpulse<P>, NormalImpulse<P>,
/// RoughImpulse<P> or (slower) an Outcome<P>. An array of outcomes may be the array of the contacts' velocities that it
/// replaces. Otherwise no two arrays overlap.
template <class P, class Solver>
void solve_packs(const PackTask<typename P::value_type>& task, const Solver& solver) {
  constexpr std::size_t width = P::size();
  const detail::BlockPrefetch prefetch(task);
  const bool is_large = prefetch.pays();
  std::size_t i = 0;
  // For large arrays, two packs at a time take an eighth longer than one pack at a time.
  for (; !is_large && i + 2 * width <= task.count; i += 2 * width) {
    detail::solve_from<P, 2>(task, i, solver);
  }
  for (; i + width <= task.count; i += width) {
    if (is_large) {
      prefetch.ask(i, width);
    }
    detail::solve_from<P, 1>(task, i, solver);
  }
  if (i < task.count) {
    detail::OnePack<P> rest(task, i);
    detail::solve_from<P, 1>(rest.task(), 0, solver);
    rest.write_to(task, i);
  }
}

}  // namespace carom::impulse
