// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <stdexcept>

#include <carom/collision/model.hpp>
#include <carom/impulse/batch/contact_arrays.hpp>
#include <carom/impulse/batch/contact_batch.hpp>
#include <carom/impulse/batch/instruction_set.hpp>
#include <carom/impulse/batch/pack_task.hpp>

/// Many contacts at once: the text of the laws of laws.hpp in packs, one contact a lane.
/// Every instruction set gives the same bits, which are those of the scalar solvers compiled without contraction of a·b
/// + c. The library carom::batch holds the code.
namespace carom::impulse {

/// Solves every contact; no two contacts depend on each other. An array of outcomes may be the array of the velocities
/// that it replaces; otherwise no two arrays overlap. Preconditions: each contact was made from a valid collision; the
/// model is one of `models_with_truth`. Throws std::invalid_argument for the model `any`, for arrays of different
/// lengths, and for an instruction set that is not available.
void solve(const ContactArrays<const float>& contacts, Model model, const OutcomeArrays<float>& outcomes,
           InstructionSet set = best_instruction_set());
void solve(const ContactArrays<const double>& contacts, Model model, const OutcomeArrays<double>& outcomes,
           InstructionSet set = best_instruction_set());

/// The same for arrays that are known to have one length, `task.count`.
void solve(const PackTask<float>& task, Model model, InstructionSet set = best_instruction_set());
void solve(const PackTask<double>& task, Model model, InstructionSet set = best_instruction_set());

/// The same for a batch, whose arrays need no check each: a call takes a quarter of the time.
template <class S>
void solve(const ContactBatch<S>& contacts, Model model, OutcomeBatch<S>& outcomes,
           InstructionSet set = best_instruction_set()) {
  if (contacts.size() != outcomes.size()) {
    throw std::invalid_argument("carom::impulse::solve: batches of different sizes");
  }
  PackTask<S> task;
  for (std::size_t k = 0; k < contact_number_count; ++k) {
    task.contacts[k] = contacts.begin_of(k);
  }
  for (std::size_t k = 0; k < outcome_number_count; ++k) {
    task.outcomes[k] = outcomes.begin_of(k);
  }
  task.count = contacts.size();
  solve(task, model, set);
}

}  // namespace carom::impulse
