// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>

/// The most multiplications and additions, one after the other and not fused, as the batch solvers are compiled: what a
/// roofline's flat part is. One namespace for each instruction set.
#define CAROM_DECLARE_PEAK(SET)                            \
  namespace carom::benchmarks::SET {                       \
  /** How many operations were made; keeps `sink` alive.*/ \
  std::size_t multiply_and_add(double* sink);              \
  }

CAROM_DECLARE_PEAK(baseline)
CAROM_DECLARE_PEAK(avx2)
CAROM_DECLARE_PEAK(avx512)
