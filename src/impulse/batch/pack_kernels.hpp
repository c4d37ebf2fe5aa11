// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/batch/solve_packs.hpp>

/// The units that pack_kernels.cpp is compiled to, one a namespace for each instruction set. What is declared here
/// takes pointers alone: a unit of a wide instruction set must define nothing that another unit could be linked with
/// (tests/impulse/batch/isolation.cmake).
#define CAROM_DECLARE_PACK_KERNELS(SET)                  \
  namespace carom::impulse::SET {                        \
  void solve_frictionless(const PackTask<float>& task);  \
  void solve_frictionless(const PackTask<double>& task); \
  void solve_reflection(const PackTask<float>& task);    \
  void solve_reflection(const PackTask<double>& task);   \
  }

CAROM_DECLARE_PACK_KERNELS(baseline)
CAROM_DECLARE_PACK_KERNELS(avx2)
CAROM_DECLARE_PACK_KERNELS(avx512)
