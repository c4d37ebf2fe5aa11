// SPDX-License-Identifier: BSL-1.0
#include <exception>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include <carom/properties/gate/answers.hpp>

namespace carom::properties {

std::vector<Answer> answers_of(Session& session, std::span<const Collision> collisions) {
  std::vector<Answer> answers = of_subject([&] { return session(collisions); });
  if (answers.size() != collisions.size()) {
    throw SubjectError("the session gave " + std::to_string(answers.size()) + " answers to " +
                       std::to_string(collisions.size()) + " collisions");
  }
  return answers;
}

namespace {

using Clock = std::chrono::steady_clock;

class RestartingSession {
 public:
  RestartingSession(const Subject& subject, Restarts& restarts, std::stop_token stop)
      : open_(subject.open), session_(of_subject(open_)), restarts_(&restarts), stop_(std::move(stop)) {}

  [[nodiscard]] std::vector<Answer> solve(std::span<const Collision> collisions) {
    if (is_over_) {
      throw SubjectError("a session that failed for good is asked again");
    }
    std::vector<Answer> answers;
    while (answers.size() < collisions.size()) {
      const auto start = Clock::now();
      try {
        append(answers, answers_of(session_, collisions.subspan(answers.size())));
      } catch (const SessionFailure& failure) {
        append(answers, failure.answered());
        is_over_ = true;
        if (stop_.stop_requested()) {
          throw SessionFailure(failure.what(), answers, failure.failed());
        }
        const bool may_restart = restarts_->may_restart_after(Clock::now() - start);
        answers.emplace_back(failure.failed());
        start_again(failure, answers, may_restart);
      }
    }
    return answers;
  }

  void close() {
    of_subject([this] { session_.close(); });
  }

 private:
  static void append(std::vector<Answer>& answers, std::vector<Answer> more) {
    if (answers.empty()) {
      answers.swap(more);
      return;
    }
    answers.insert(answers.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }

  void start_again(const SessionFailure& failure, const std::vector<Answer>& answers, bool may_restart) {
    session_ = Session();
    if (!may_restart) {
      throw SessionFailure("it failed " + std::to_string(restarts_->most()) +
                               " times, and the gate stops judging it; the last failure: " + failure.what(),
                           answers, failure.failed());
    }
    try {
      session_ = open_();
      is_over_ = false;
    } catch (const std::exception& error) {
      throw SessionFailure(std::string("it cannot be restarted after a failure: ") + error.what(), answers,
                           failure.failed());
    }
  }

  std::function<Session()> open_;
  Session session_;
  Restarts* restarts_;
  std::stop_token stop_;
  bool is_over_ = false;
};

}  // namespace

bool Restarts::may_restart_after(std::chrono::nanoseconds took) {
  const bool is_last = ++failures_ >= most_;
  nanoseconds_ += took.count();
  if (is_last || (longest_ && nanoseconds_ >= longest_->count())) {
    are_spent_ = true;
  }
  return !are_spent_;
}

Session open_restarting(const Subject& subject, Restarts& restarts, std::stop_token stop) {
  const auto session = std::make_shared<RestartingSession>(subject, restarts, std::move(stop));
  return {[session](std::span<const Collision> collisions) { return session->solve(collisions); },
          [session] { session->close(); }};
}

}  // namespace carom::properties
