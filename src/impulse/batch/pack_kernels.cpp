// SPDX-License-Identifier: BSL-1.0
// Compiled once for each instruction set, named CAROM_INSTRUCTION_SET.
#include <carom/impulse/batch/pack_kernels.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>

namespace carom::impulse::CAROM_INSTRUCTION_SET {
namespace {

template <class S>
void frictionless_packs(const PackTask<S>& task) {
  solve_packs<Pack<S>>(task, [](const Contact<Pack<S>>& contact) { return frictionless_impulse(contact); });
}

template <class S>
void reflection_packs(const PackTask<S>& task) {
  solve_packs<Pack<S>>(task, [](const Contact<Pack<S>>& contact) { return reflection_impulse<Ldlt>(contact); });
}

}  // namespace

// Everything is inlined: a function left standing could be the one that another unit is linked with.
[[gnu::flatten]] void solve_frictionless(const PackTask<float>& task) { frictionless_packs(task); }
[[gnu::flatten]] void solve_frictionless(const PackTask<double>& task) { frictionless_packs(task); }
[[gnu::flatten]] void solve_reflection(const PackTask<float>& task) { reflection_packs(task); }
[[gnu::flatten]] void solve_reflection(const PackTask<double>& task) { reflection_packs(task); }

}  // namespace carom::impulse::CAROM_INSTRUCTION_SET
