// SPDX-License-Identifier: BSL-1.0
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

#include <carom/collision/expects.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/subjects/protocol/command_line.hpp>
#include <carom/subjects/protocol/exec.hpp>
#include <carom/subjects/protocol/hex_lines.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/subjects/protocol/spelling.hpp>

namespace carom::subjects::protocol {
namespace {

constexpr std::size_t longest_shown_request = 4000;  // bytes

class Conversation {
 public:
  Conversation(const std::vector<std::string>& words, const ExecOptions& options)
      : process_(words, options.limits, options.stop), spelling_(options.spelling) {
    request_ = start_request();
    run_with_described_failure("start", [&] {
      process_.exchange(request_, 1, [&](std::string_view line) { introduction_ = introduction_from(line); });
    });
  }

  [[nodiscard]] const Introduction& introduction() const { return introduction_; }

  [[nodiscard]] std::vector<Answer> solve(std::span<const Collision> collisions) {
    std::vector<Answer> answers;
    if (collisions.empty()) {
      return answers;  // a failure names a collision
    }
    answers.reserve(collisions.size());
    std::string requests;
    for (std::size_t i = 0; i < collisions.size(); ++i) {
      add_request(requests, i, collisions[i]);
    }
    try {
      process_.exchange(requests, collisions.size(), [&](std::string_view line) {
        answers.push_back(answer_to(collisions[answers.size()], line, next_id_ + answers.size()));
      });
    } catch (const ChildError& error) {
      fail(collisions, answers, error, error.what());
    } catch (const std::exception& error) {
      fail(collisions, answers, error, std::string("wrote an invalid reply: ") + error.what());
    }
    next_id_ += collisions.size();
    ++call_;
    return answers;
  }

  void stop() {
    request_ = stop_request();
    run_with_described_failure("stop", [&] { process_.finish(request_); });
  }

 private:
  [[nodiscard]] Answer answer_to(const Collision& collision, std::string_view line, std::uint64_t id) const {
    Answer answer = introduction_.numbers == Numbers::hex
                        ? answer_from_hex(line, id, introduction_.matrix)
                        : answer_from(line, id, introduction_.precision, introduction_.matrix);
    const auto* outcome = std::get_if<ReportedOutcome>(&answer);
    if (outcome != nullptr && introduction_.matrix && !outcome->collision_matrix &&
        owes_matrix(collision, *outcome, introduction_.precision)) {
      throw FormatError("/C", "is missing, but the contact collides and the start reply says \"matrix\": true");
    }
    return answer;
  }

  /// Appends the request for collision number `place` of the current call of solve().
  void add_request(std::string& requests, std::size_t place, const Collision& collision) const {
    if (introduction_.numbers == Numbers::hex) {
      add_hex_request(requests, next_id_ + place, collision);
      return;
    }
    const auto turning = static_cast<unsigned>((hash_of(collision) + call_) % spelling_count);
    requests += solve_request(next_id_ + place, collision, spelling_.value_or(turning));
  }

  [[noreturn]] void fail(std::span<const Collision> collisions, const std::vector<Answer>& answers,
                         const std::exception& error, const std::string& why) {
    const std::size_t failed = std::min(answers.size(), collisions.size() - 1);
    request_.clear();
    add_request(request_, failed, collisions[failed]);
    throw SessionFailure(description("solve " + std::to_string(next_id_ + failed), error), answers,
                         {printable(why, longest_shown_request), errors_and_request()});
  }

  template <class F>
  void run_with_described_failure(const std::string& request, const F& f) {
    try {
      f();
    } catch (const std::exception& error) {
      throw std::runtime_error(description(request, error));
    }
  }

  std::string description(const std::string& request, const std::exception& error) {
    return request + ": " + printable(error.what(), longest_shown_request) + '\n' + errors_and_request();
  }

  std::string errors_and_request() {
    std::string text = "request: " + printable(request_.substr(0, request_.size() - 1), longest_shown_request);
    if (const std::string errors = process_.standard_error(); !errors.empty()) {
      text += "\nstandard error: " + printable(errors, errors.size());
    }
    return text;
  }

  ChildProcess process_;
  Introduction introduction_;
  std::string request_;
  std::uint64_t next_id_ = 1;
  std::optional<unsigned> spelling_;  // of every request; if empty, it changes from call to call
  std::uint64_t call_ = 0;            // the number of earlier calls of solve()
};

/// Keeps the conversation of the introduction for the first session, because starting an interpreter is slow.
class FirstConversation {
 public:
  explicit FirstConversation(std::shared_ptr<Conversation> conversation) : conversation_(std::move(conversation)) {}

  /// The conversation for the first caller; null afterwards.
  [[nodiscard]] std::shared_ptr<Conversation> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(conversation_, nullptr);
  }

 private:
  std::mutex mutex_;
  std::shared_ptr<Conversation> conversation_;
};

Session open_session(const std::vector<std::string>& words, const ExecOptions& options,
                     const Introduction& introduction, FirstConversation& first) {
  std::shared_ptr<Conversation> conversation = first.take();
  if (conversation == nullptr) {
    conversation = std::make_shared<Conversation>(words, options);
  }
  if (conversation->introduction() != introduction) {
    throw std::runtime_error(
        "start: the second start reply differs from the first one; a program must always introduce itself in the same "
        "way");
  }
  return {[conversation](std::span<const Collision> collisions) { return conversation->solve(collisions); },
          [conversation] { conversation->stop(); }};
}

}  // namespace

Subject exec_subject(const std::string& specification, const ExecOptions& options) {
  CAROM_EXPECTS(specification.starts_with(exec_prefix), specification);
  Subject subject;
  subject.name = specification;
  subject.specification = specification;
  try {
    const std::vector<std::string> words = split_words(std::string_view(specification).substr(exec_prefix.size()));
    if (words.empty()) {
      throw std::invalid_argument("no program is given after exec:");
    }
    auto conversation = std::make_shared<Conversation>(words, options);
    const Introduction introduction = conversation->introduction();
    introduce(subject, introduction);
    subject.spellings = introduction.numbers == Numbers::hex ? 1 : spelling_count;
    const auto first = std::make_shared<FirstConversation>(std::move(conversation));
    subject.open = [words, options, introduction, first] { return open_session(words, options, introduction, *first); };
  } catch (const std::exception& error) {
    subject.open = [reason = std::string(error.what())]() -> Session { throw std::runtime_error(reason); };
  }
  return subject;
}

}  // namespace carom::subjects::protocol
