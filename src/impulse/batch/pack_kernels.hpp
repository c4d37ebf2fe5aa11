// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/law.hpp>
#include <carom/impulse/batch/contact_arrays.hpp>

/// The units that pack_kernels.cpp compiles to, one namespace for each instruction set. A unit of a wide instruction
/// set must not define anything that the linker could use in another unit (tests/impulse/batch/isolation.cmake).
#define CAROM_DECLARE_PACK_KERNELS(SET)                    \
  namespace carom::impulse::SET {                          \
  void solve_packs(const PackTask<float>& task, Law law);  \
  void solve_packs(const PackTask<double>& task, Law law); \
  }

CAROM_DECLARE_PACK_KERNELS(baseline)
CAROM_DECLARE_PACK_KERNELS(avx2)
CAROM_DECLARE_PACK_KERNELS(avx512)
