// SPDX-License-Identifier: BSL-1.0
#include <carom/impulse/batch/instruction_set.hpp>

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

}  // namespace carom::impulse
