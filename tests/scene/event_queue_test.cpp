// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/conformance/rapidcheck.hpp>
#include <carom/scene/event_queue.hpp>

namespace carom::scene {
namespace {

TEST(EventQueue, IsAListAndItsLeast) {
  properties::check(200, [] {
    properties::Stream stream = properties::stream_from(*rc::gen::arbitrary<std::uint64_t>());
    const auto count = static_cast<std::size_t>(stream.integer(1, 40));
    EventQueue queue(count);
    std::vector<double> times(count, never);
    for (int change = 0; change < 200; ++change) {
      const auto index = static_cast<std::size_t>(stream.integer(0, static_cast<int>(count) - 1));
      // Equal times are common.
      const double time = stream.chance(5) ? never : stream.integer(0, 20) / 4.0;
      times[index] = time;
      queue.set(static_cast<EventQueue::Index>(index), time);
      RC_ASSERT(queue.time_of(static_cast<EventQueue::Index>(index)) == time);
      // Of equal times the first.
      const auto least = std::min_element(times.begin(), times.end());
      RC_ASSERT(queue.first() == static_cast<EventQueue::Index>(least - times.begin()));
      const double latest = stream.integer(-1, 21) / 4.0;
      std::multiset<EventQueue::Index> expected;
      for (std::size_t k = 0; k < count; ++k) {
        if (times[k] <= latest) {
          expected.insert(static_cast<EventQueue::Index>(k));
        }
      }
      std::multiset<EventQueue::Index> found;
      queue.for_each_until(latest, [&](EventQueue::Index k) { found.insert(k); });
      RC_ASSERT(found == expected);
    }
  });
}

TEST(EventQueue, WithoutEventsHasNone) {
  const EventQueue queue(5);
  EXPECT_EQ(queue.time_of(queue.first()), never);
  int visited = 0;
  queue.for_each_until(1e300, [&](EventQueue::Index) { ++visited; });
  EXPECT_EQ(visited, 0);
}

}  // namespace
}  // namespace carom::scene
