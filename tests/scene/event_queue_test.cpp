// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/event_queue.hpp>

namespace carom::scene {
namespace {

TEST(EventQueue, GivesTheEarliestOfAListOfTimes) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const auto count = static_cast<std::size_t>(stream.integer(1, 40));
    EventQueue queue(count);
    std::vector<double> times(count, never);
    for (int change = 0; change < 200; ++change) {
      const auto index = static_cast<std::size_t>(stream.integer(0, static_cast<int>(count) - 1));
      const double time = stream.chance(5) ? never : stream.integer(0, 20) / 4.0;
      times[index] = time;
      queue.set(static_cast<EventQueue::Index>(index), time);
      ASSERT_TRUE(queue.time_of(static_cast<EventQueue::Index>(index)) == time) << seed;
      const auto least = std::min_element(times.begin(), times.end());
      ASSERT_TRUE(queue.first() == static_cast<EventQueue::Index>(least - times.begin())) << seed;
      const double latest = stream.integer(-1, 21) / 4.0;
      std::multiset<EventQueue::Index> expected;
      for (std::size_t k = 0; k < count; ++k) {
        if (times[k] <= latest) {
          expected.insert(static_cast<EventQueue::Index>(k));
        }
      }
      std::multiset<EventQueue::Index> found;
      queue.for_each_until(latest, [&](EventQueue::Index k) { found.insert(k); });
      ASSERT_TRUE(found == expected) << seed;
    }
  }
}

}  // namespace
}  // namespace carom::scene
