// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string_view>

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

/// Whether this machine has the instruction set and the library is compiled for it.
[[nodiscard]] bool is_available(InstructionSet set);

/// The widest available instruction set.
[[nodiscard]] InstructionSet best_instruction_set();

}  // namespace carom::impulse
