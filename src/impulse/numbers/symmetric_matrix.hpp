// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>

namespace carom::impulse {

/// The symmetric matrix whose entries are entry(i, j) on and below the diagonal. The entries are written one by one,
/// because gcc keeps a matrix of packs in memory if an index is a variable.
template <class S, class Entry>
[[nodiscard]] Matrix3<S> symmetric_matrix(const Entry& entry) {
  Matrix3<S> matrix;
  matrix(0, 0) = entry(0, 0);
  matrix(1, 1) = entry(1, 1);
  matrix(2, 2) = entry(2, 2);
  matrix(1, 0) = matrix(0, 1) = entry(1, 0);
  matrix(2, 0) = matrix(0, 2) = entry(2, 0);
  matrix(2, 1) = matrix(1, 2) = entry(2, 1);
  return matrix;
}

}  // namespace carom::impulse
