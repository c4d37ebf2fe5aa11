// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string_view>

#include <carom/collision/enum_array.hpp>
#include <carom/collision/law.hpp>
#include <carom/impulse/batch/contact_arrays.hpp>
#include <carom/impulse/batch/contact_batch.hpp>

/// Solves many contacts with the laws of laws.hpp, one contact in each lane of a pack. Every instruction set gives the
/// same bits as the scalar solvers compiled without contraction of a·b + c. The library is carom::batch.
namespace carom::impulse {

/// The instruction sets that the batch solvers are compiled for. A pack of double has 2, 4 or 8 lanes.
enum class InstructionSet {
  baseline,  // available on every machine of the architecture: SSE2 on x86-64, NEON on AArch64
  avx2,      // only on x86-64
  avx512,    // F, DQ and VL; only on x86-64
};

inline constexpr std::array<InstructionSet, 3> all_instruction_sets{InstructionSet::baseline, InstructionSet::avx2,
                                                                    InstructionSet::avx512};

[[nodiscard]] constexpr std::string_view name_of(InstructionSet set) {
  constexpr EnumArray<InstructionSet, std::string_view, all_instruction_sets.size()> names{"baseline", "avx2",
                                                                                           "avx512"};
  return names[set];
}

/// Whether this machine has the instruction set and the library is compiled for it.
[[nodiscard]] bool is_available(InstructionSet set);

/// The widest available instruction set.
[[nodiscard]] InstructionSet best_instruction_set();

/// Solves every contact. An array of outcomes may be the array of the contacts' velocities that it replaces. Otherwise
/// no two arrays overlap. Preconditions: each contact was made from a valid collision; the law is one of
/// `laws_with_truth`. Throws std::invalid_argument for any other law, for arrays of different lengths, and for an
/// instruction set that is not available.
void solve(const ContactArrays<const float>& contacts, Law law, const OutcomeArrays<float>& outcomes,
           InstructionSet set = best_instruction_set());
void solve(const ContactArrays<const double>& contacts, Law law, const OutcomeArrays<double>& outcomes,
           InstructionSet set = best_instruction_set());

/// Solves arrays of the length `task.count`. Preconditions and other errors are those of the functions above.
void solve(const PackTask<float>& task, Law law, InstructionSet set = best_instruction_set());
void solve(const PackTask<double>& task, Law law, InstructionSet set = best_instruction_set());

/// Solves a batch. For few contacts, this takes a quarter of the time of a call with ContactArrays, because it checks
/// no lengths of arrays. Throws std::invalid_argument if the sizes of the batches differ.
template <class S>
void solve(const ContactBatch<S>& contacts, Law law, OutcomeBatch<S>& outcomes,
           InstructionSet set = best_instruction_set()) {
  if (contacts.size() != outcomes.size()) {
    throw std::invalid_argument("carom::impulse::solve: the batches have different sizes");
  }
  PackTask<S> task;
  for (std::size_t k = 0; k < contact_number_count; ++k) {
    task.contacts[k] = contacts.begin_of(k);
  }
  for (std::size_t k = 0; k < outcome_number_count; ++k) {
    task.outcomes[k] = outcomes.begin_of(k);
  }
  task.count = contacts.size();
  solve(task, law, set);
}

}  // namespace carom::impulse
