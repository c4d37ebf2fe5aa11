// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/model.hpp>
#include <carom/impulse/batch/pack_task.hpp>

/// The units that pack_kernels.cpp is compiled to, one a namespace for each instruction set. What is declared here
/// takes pointers and enumerators alone: a unit of a wide instruction set must define nothing that another unit could
/// be linked with (tests/impulse/batch/isolation.cmake).
#define CAROM_DECLARE_PACK_KERNELS(SET)                        \
  namespace carom::impulse::SET {                              \
  void solve_packs(const PackTask<float>& task, Model model);  \
  void solve_packs(const PackTask<double>& task, Model model); \
  }

CAROM_DECLARE_PACK_KERNELS(baseline)
CAROM_DECLARE_PACK_KERNELS(avx2)
CAROM_DECLARE_PACK_KERNELS(avx512)
