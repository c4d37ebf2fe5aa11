// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string_view>

namespace carom::impulse {

/// What the batch solvers are compiled for. Packs of double have 2, 4, 8 lanes.
enum class InstructionSet {
  baseline,  // what every machine of the architecture has: SSE2 on x86-64, NEON on AArch64
  avx2,      // x86-64 alone
  avx512,    // F, DQ and VL; x86-64 alone
};

inline constexpr std::array<InstructionSet, 3> all_instruction_sets{InstructionSet::baseline, InstructionSet::avx2,
                                                                    InstructionSet::avx512};

[[nodiscard]] constexpr std::string_view name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::baseline:
      break;
  }
  return "baseline";
}

/// Whether this machine has it, and the library was compiled for it.
[[nodiscard]] bool is_available(InstructionSet set);

/// The widest that is available.
[[nodiscard]] InstructionSet best_instruction_set();

}  // namespace carom::impulse
