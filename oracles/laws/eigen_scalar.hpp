// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace carom::oracles {

/// What Eigen asks of a scalar type T that is a field of its own: real, signed, constructed from int, without
/// functions of analysis; with the costs of reading, adding and multiplying, in cycles or so. NumTraits<T> derives
/// from it.
template <class T, int Read, int Add, int Multiply>
struct EigenScalar : Eigen::GenericNumTraits<T> {
  using Real = T;
  using NonInteger = T;
  using Nested = T;
  using Literal = T;
  static int digits10() { return 0; }  // of no fixed number of digits
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
