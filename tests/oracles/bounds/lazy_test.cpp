// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/oracles/bounds/lazy.hpp>

namespace carom::oracles {
namespace {

TEST(LazyMap, ComputesEachValueOnceAndKeepsItInPlace) {
  LazyMap<int, int> squares;
  int computed = 0;
  const auto square = [&](int key) -> const int& {
    return squares.get(key, [&] {
      ++computed;
      return key * key;
    });
  };
  const int& first = square(3);
  for (int key = 0; key < 100; ++key) {
    EXPECT_EQ(square(key), key * key);
  }
  EXPECT_EQ(&square(3), &first);
  EXPECT_EQ(computed, 100);
}

}  // namespace
}  // namespace carom::oracles
