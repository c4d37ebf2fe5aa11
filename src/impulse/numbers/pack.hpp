// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <experimental/simd>

#if defined(__clang__) && defined(__AVX512F__)
#error "Compiled by clang 14 for AVX-512, where(mask, x) = y of libstdc++ 12 assigns nothing: use -mno-avx512f, or gcc"
#endif

/// Packs of numbers as the scalar type of the solvers, with one contact in each lane.
namespace carom::impulse {

/// As many numbers as one register holds, in the instruction set of the including unit.
template <class S>
using Pack = std::experimental::native_simd<S>;

}  // namespace carom::impulse

/// Lets Eigen store packs, as real numbers.
template <class S, class Abi>
struct Eigen::NumTraits<std::experimental::simd<S, Abi>> {
  using Real = std::experimental::simd<S, Abi>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = S;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};
