// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/gate/task.hpp>

namespace carom::properties {
namespace {

GateOptions options_to_schedule(std::uint64_t of_each) {
  GateOptions options;
  options.cases = of_each;
  options.families = pointers_to(all_families());
  return options;
}

std::vector<Task> first_tasks(const GateOptions& options, std::size_t most) {
  Schedule schedule(options);
  std::vector<Task> tasks;
  while (tasks.size() < most) {
    const auto task = schedule.next();
    if (!task) {
      break;
    }
    tasks.push_back(*task);
  }
  return tasks;
}

constexpr std::size_t every_task = 1'000'000;

TEST(Schedule, HasEveryCaseInOneTask) {
  const GateOptions options = options_to_schedule(137);
  std::vector<std::uint64_t> drawn(options.families.size());
  std::uint64_t number = 0;
  for (const Task& task : first_tasks(options, every_task)) {
    EXPECT_EQ(task.number, number++);
    EXPECT_EQ(task.first, drawn[task.family]) << "cases come in the order of their numbers";
    EXPECT_LT(task.first, task.last);
    EXPECT_LE(task.last, task.first + 50);
    drawn[task.family] = task.last;
  }
  for (std::size_t f = 0; f < drawn.size(); ++f) {
    EXPECT_EQ(drawn[f], cases_of(options, *options.families[f])) << options.families[f]->name;
  }
}

TEST(Schedule, TakesFamiliesInTurnFromOneCaseOn) {
  const GateOptions options = options_to_schedule(1000);
  std::set<std::size_t> had;
  for (const Task& task : first_tasks(options, options.families.size())) {
    EXPECT_TRUE(had.insert(task.family).second) << "again before the others had their turn";
    EXPECT_EQ(task.last - task.first, static_cast<std::uint64_t>(options.families[task.family]->weight));
  }
}

TEST(Schedule, DoesNotDependOnTheOrderInWhichFamiliesAreReported) {
  const GateOptions options = options_to_schedule(100);
  GateOptions reversed = options;
  std::reverse(reversed.families.begin(), reversed.families.end());
  const std::vector<Task> tasks = first_tasks(options, every_task);
  const std::vector<Task> others = first_tasks(reversed, every_task);
  ASSERT_EQ(tasks.size(), others.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    EXPECT_EQ(options.families[tasks[i].family], reversed.families[others[i].family])
        << "a family has no place in the order";
    EXPECT_EQ(tasks[i].first, others[i].first);
  }
}

/// Even with a budget, the cases come in the order of their numbers. So a longer run starts with the cases of a shorter
/// run.
TEST(Schedule, GoesOnWithoutEndOnABudget) {
  GateOptions options = options_to_schedule(1);
  options.budget = std::chrono::seconds(1);
  const std::vector<Task> tasks = first_tasks(options, 5000);
  ASSERT_EQ(tasks.size(), 5000U);
  std::map<std::size_t, std::uint64_t> drawn;
  for (const Task& task : tasks) {
    EXPECT_EQ(task.first, drawn[task.family]);
    drawn[task.family] = task.last;
  }
  EXPECT_EQ(drawn.size(), options.families.size());
}

TEST(Schedule, IsOverAtOnceWithoutFamilies) { EXPECT_FALSE(Schedule(GateOptions()).next()); }

TEST(Schedule, OfAllShardsHasEveryCaseOnce) {
  for (const std::uint64_t of_each : {1U, 2U, 7U, 137U}) {
    GateOptions options = options_to_schedule(of_each);
    std::map<std::size_t, std::multiset<std::uint64_t>> numbers;
    for (options.shard = {1, 3}; options.shard.number <= options.shard.of; ++options.shard.number) {
      for (const Task& task : first_tasks(options, every_task)) {
        for (std::uint64_t i = 0; i < task.last - task.first; ++i) {
          EXPECT_EQ(task.case_number(i) % 3, options.shard.number - 1);
          numbers[task.family].insert(task.case_number(i));
        }
      }
    }
    options.shard = {};
    for (std::size_t f = 0; f < options.families.size(); ++f) {
      const std::uint64_t all = cases_of(options, *options.families[f]);
      ASSERT_EQ(numbers[f].size(), all);
      EXPECT_EQ(std::set<std::uint64_t>(numbers[f].begin(), numbers[f].end()).size(), all) << "each once";
      EXPECT_EQ(*numbers[f].rbegin(), all - 1);
    }
  }
}

}  // namespace
}  // namespace carom::properties
