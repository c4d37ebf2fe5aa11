// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>

/// The peak rate of multiplications and additions (not fused, as in the batch solvers) for each instruction set.
#define CAROM_DECLARE_PEAK(SET)                        \
  namespace carom::benchmarks::SET {                   \
  /** The number of operations; keeps `sink` alive. */ \
  std::size_t multiply_and_add(double* sink);          \
  }

CAROM_DECLARE_PEAK(baseline)
CAROM_DECLARE_PEAK(avx2)
CAROM_DECLARE_PEAK(avx512)
