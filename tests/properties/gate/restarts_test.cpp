// SPDX-License-Identifier: BSL-1.0

#include <gtest/gtest.h>

#include <carom/properties/gate/answers.hpp>

#include "support/expect_in.hpp"

namespace carom::properties {
namespace {

/// A subject that fails on every collision whose restitution is 1. Counts how often the gate opens it.
Subject fragile(int& opened, int most_opened = 1000) {
  Subject subject;
  subject.name = "fragile";
  subject.open = [&opened, most_opened]() -> Session {
    if (opened == most_opened) {
      throw std::runtime_error("there is no more of it");
    }
    ++opened;
    return Session([](std::span<const Collision> collisions) {
      std::vector<Answer> answers;
      for (const Collision& collision : collisions) {
        if (collision.restitution == 1) {
          throw SessionFailure("solve: broke", answers, {"broke"});
        }
        answers.emplace_back(Refused{"sound"});
      }
      return answers;
    });
  };
  return subject;
}

std::vector<Collision> collisions(std::initializer_list<double> restitutions) {
  std::vector<Collision> all;
  for (const double restitution : restitutions) {
    all.emplace_back().restitution = restitution;
  }
  return all;
}

TEST(Restarts, AnswerAFailureAndAskTheOtherCollisions) {
  int opened = 0;
  Restarts restarts(10);
  Session session = open_restarting(fragile(opened), restarts);
  const std::vector<Answer> answers = session(collisions({1, 0, 0, 1, 1, 0, 1}));
  ASSERT_EQ(answers.size(), 7U);
  for (const std::size_t failed : {0U, 3U, 4U, 6U}) {
    EXPECT_EQ(std::get<Failed>(answers[failed]).why, "broke");
  }
  for (const std::size_t sound : {1U, 2U, 5U}) {
    EXPECT_EQ(std::get<Refused>(answers[sound]).why, "sound");
  }
  EXPECT_EQ(opened, 5);
  EXPECT_FALSE(restarts.are_spent());
}

TEST(Restarts, EndAfterTheGivenNumberOfFailures) {
  int opened = 0;
  Restarts restarts(2);
  Session session = open_restarting(fragile(opened), restarts);
  try {
    (void)session(collisions({0, 1, 0, 1, 0}));
    FAIL() << "it may fail once, and fails twice";
  } catch (const SessionFailure& failure) {
    EXPECT_EQ(failure.answered().size(), 4U) << "what was answered until then, the failures with it";
    unit::expect_in(std::string(failure.what()), {"failed 2 times"});
  }
  EXPECT_TRUE(restarts.are_spent());
  EXPECT_THROW((void)session(collisions({0})), std::runtime_error);
}

TEST(Restarts, EndAfterTheGivenTimeOfFailures) {
  Restarts restarts(1000, std::chrono::seconds(10));
  EXPECT_TRUE(restarts.may_restart_after(std::chrono::seconds(9)));
  EXPECT_FALSE(restarts.may_restart_after(std::chrono::seconds(2)));
}

TEST(Restarts, TellWhyASubjectCannotStartAgain) {
  int opened = 0;
  Restarts restarts(10);
  Session session = open_restarting(fragile(opened, 1), restarts);
  try {
    (void)session(collisions({0, 1, 0}));
    FAIL() << "it cannot be opened twice";
  } catch (const SessionFailure& failure) {
    EXPECT_EQ(failure.answered().size(), 2U);
    unit::expect_in(std::string(failure.what()), {"there is no more of it"});
  }
}

TEST(Restarts, DoNotCountAStopAsAFailure) {
  int opened = 0;
  Restarts restarts(10);
  std::stop_source stop;
  Session session = open_restarting(fragile(opened), restarts, stop.get_token());
  stop.request_stop();
  EXPECT_THROW((void)session(collisions({1})), SessionFailure);
  EXPECT_EQ(opened, 1);
  EXPECT_TRUE(restarts.may_restart_after(std::chrono::seconds(0)));
}

}  // namespace
}  // namespace carom::properties
