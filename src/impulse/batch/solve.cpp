// SPDX-License-Identifier: BSL-1.0
#include <stdexcept>
#include <string>

#include <carom/collision/expects.hpp>
#include <carom/impulse/batch/pack_kernels.hpp>
#include <carom/impulse/batch/solve.hpp>

namespace carom::impulse {

bool is_available(InstructionSet set) {
#ifdef CAROM_BATCH_HAS_avx512
  if (set == InstructionSet::avx512) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
  }
#endif
#ifdef CAROM_BATCH_HAS_avx2
  if (set == InstructionSet::avx2) {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  }
#endif
  return set == InstructionSet::baseline;
}

InstructionSet best_instruction_set() {
  static const InstructionSet best = [] {
    InstructionSet widest = InstructionSet::baseline;
    for (const InstructionSet set : all_instruction_sets) {
      widest = is_available(set) ? set : widest;
    }
    return widest;
  }();
  return best;
}

namespace {

template <class S>
PackTask<S> task_of(ContactArrays<const S> contacts, OutcomeArrays<S> outcomes) {
  PackTask<S> task;
  task.count = contacts.size();
  std::size_t k = 0;
  const auto begin_of = [&](const auto& array) {
    if (array.size() != task.count) {
      throw std::invalid_argument("carom::impulse::solve: the arrays have different lengths");
    }
    return array.data();
  };
  for_each_array(contacts, [&](const std::span<const S>& array) { task.contacts[k++] = begin_of(array); });
  k = 0;
  for_each_array(outcomes, [&](const std::span<S>& array) { task.outcomes[k++] = begin_of(array); });
  return task;
}

template <class S>
bool are_made_of_valid(const PackTask<S>& task) {
  for (std::size_t i = 0; i < task.count; ++i) {
    if (!is_made_of_valid(contact_of<S>([&](std::size_t k) { return task.contacts[k][i]; }))) {
      return false;
    }
  }
  return true;
}

template <class S>
void solve_task(const PackTask<S>& task, Law law, InstructionSet set) {
  if (!is_available(set)) {
    throw std::invalid_argument("carom::impulse::solve: this machine does not support " + std::string(name_of(set)));
  }
  if (!determines_outcome(law)) {
    throw std::invalid_argument("carom::impulse::solve: batches do not support the outcome `" +
                                std::string(name_of(law)) + "`; use frictionless, reflection, sticking or rough");
  }
  CAROM_EXPECTS(are_made_of_valid(task), task.count);
#ifdef CAROM_BATCH_HAS_avx512
  if (set == InstructionSet::avx512) {
    avx512::solve_packs(task, law);
    return;
  }
#endif
#ifdef CAROM_BATCH_HAS_avx2
  if (set == InstructionSet::avx2) {
    avx2::solve_packs(task, law);
    return;
  }
#endif
  baseline::solve_packs(task, law);
}

}  // namespace

void solve(const PackTask<float>& task, Law law, InstructionSet set) { solve_task(task, law, set); }

void solve(const PackTask<double>& task, Law law, InstructionSet set) { solve_task(task, law, set); }

void solve(const ContactArrays<const float>& contacts, Law law, const OutcomeArrays<float>& outcomes,
           InstructionSet set) {
  solve_task(task_of(contacts, outcomes), law, set);
}

void solve(const ContactArrays<const double>& contacts, Law law, const OutcomeArrays<double>& outcomes,
           InstructionSet set) {
  solve_task(task_of(contacts, outcomes), law, set);
}

}  // namespace carom::impulse
