// SPDX-License-Identifier: BSL-1.0
#include "io/threads.hpp"

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace carom::tool {
namespace {

TEST(Threads, DoesEachOnce) {
  for (const unsigned jobs : {0U, 1U, 3U, 40U}) {
    std::vector<std::atomic<int>> done(20);
    threads(jobs).run(done.size(), [&](std::size_t i) { ++done[i]; });
    for (const std::atomic<int>& one : done) {
      EXPECT_EQ(one, 1) << jobs;
    }
  }
}

TEST(Threads, ThrowsOnWhatAThreadThrowsAndBeginsNoMore) {
  for (const unsigned jobs : {1U, 3U}) {
    std::atomic<std::size_t> begun = 0;
    const auto work = [&](std::size_t i) {
      ++begun;
      if (i == 5) {
        throw std::runtime_error("the fifth");
      }
    };
    EXPECT_THROW(threads(jobs).run(1'000'000, work), std::runtime_error);
    EXPECT_LT(begun, 1'000'000U);
  }
}

}  // namespace
}  // namespace carom::tool
