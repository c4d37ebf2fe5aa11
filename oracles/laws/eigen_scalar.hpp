// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace carom::oracles {

/// The base of Eigen::NumTraits<T> for a signed real scalar type T. `Read`, `Add` and `Multiply` are approximate costs
/// in cycles.
template <class T, int Read, int Add, int Multiply>
struct EigenScalar : Eigen::GenericNumTraits<T> {
  using Real = T;
  using NonInteger = T;
  using Nested = T;
  using Literal = T;
  static int digits10() { return {}; }  // the number of digits is not fixed
  enum {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 1,
    ReadCost = Read,
    AddCost = Add,
    MulCost = Multiply
  };
};

}  // namespace carom::oracles
