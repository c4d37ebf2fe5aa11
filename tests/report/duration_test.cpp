// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/report/results/duration.hpp>

namespace carom::report {
namespace {

using namespace std::chrono_literals;

TEST(Duration, IsReadFromANumberAndItsUnit) {
  EXPECT_EQ(duration_from("500ms"), 500ms);
  EXPECT_EQ(duration_from("10s"), 10s);
  EXPECT_EQ(duration_from("2m"), 2min);
  EXPECT_EQ(duration_from("1h"), 1h);
  EXPECT_EQ(duration_from("1.5s"), 1500ms);
  EXPECT_EQ(duration_from("1ms"), 1ms);
  EXPECT_EQ(duration_from("1000h"), 1000h);
}

TEST(Duration, IsReadFromNoOtherText) {
  for (const char* text :
       {"",   "s",   "10",   "10 s", " 10s", "10s ",    "-1s",  "+1s",   "0s",    "0.5ms",
        "5d", "10S", "1e3s", "nans", "infs", "1s500ms", "1,5s", "0x10s", "1001h", "99999999999999999999h"}) {
    EXPECT_FALSE(duration_from(text)) << text;
  }
}

TEST(Duration, IsWrittenInTheLargestUnitThatLeavesNoFraction) {
  EXPECT_EQ(in_words(500ms), "500 ms");
  EXPECT_EQ(in_words(10s), "10 s");
  EXPECT_EQ(in_words(90s), "90 s");
  EXPECT_EQ(in_words(120s), "2 m");
  EXPECT_EQ(in_words(1500ms), "1500 ms");
  EXPECT_EQ(in_words(2h), "2 h");
  EXPECT_EQ(in_words(5us), "0 ms");
}

}  // namespace
}  // namespace carom::report
