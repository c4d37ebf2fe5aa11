// SPDX-License-Identifier: BSL-1.0
// Compiled once for each instruction set, which CAROM_INSTRUCTION_SET names.

// The preconditions of packs are not checked in any build, because a comparison of packs has no single answer
// (expects.hpp). solve.cpp checks the preconditions of each contact.
#include <carom/impulse/batch/pack_kernels.hpp>
#include <carom/impulse/batch/solve_packs.hpp>
#include <carom/impulse/laws.hpp>

namespace carom::impulse::CAROM_INSTRUCTION_SET {
namespace {

template <class S>
void solve_by_law(const PackTask<S>& task, Law law) {
  with_law(law, [&](const auto& solver) { impulse::solve_packs<Pack<S>>(task, solver); });
}

}  // namespace

// Everything is inlined. Otherwise the linker could use a function of this unit in a unit of a narrower instruction
// set.
[[gnu::flatten]] void solve_packs(const PackTask<float>& task, Law law) { solve_by_law(task, law); }
[[gnu::flatten]] void solve_packs(const PackTask<double>& task, Law law) { solve_by_law(task, law); }

}  // namespace carom::impulse::CAROM_INSTRUCTION_SET
