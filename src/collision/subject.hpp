// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <carom/collision/model.hpp>
#include <carom/collision/precision.hpp>
#include <carom/collision/solved_outcome.hpp>

namespace carom {

/// The case cannot be posed to the subject. Counted, never a pass.
struct Skipped {
  std::string why;
};

/// The subject refused the input: right for an invalid collision, wrong for a valid one.
struct Refused {
  std::string why;
};

/// The subject gave no answer: it ended, hung, or said what is no reply.
struct Failed {
  std::string why;        // one line, the same whenever the collision is asked
  std::string said = {};  // on standard error, and what else helps to find the place; may have several lines
};

using Answer = std::variant<ReportedOutcome, Skipped, Refused, Failed>;

/// A session that can go on no more, the answers that it had until then, and how it failed on the collision after them.
class SessionFailure : public std::runtime_error {
 public:
  SessionFailure(const std::string& what, std::vector<Answer> answered, Failed failed)
      : std::runtime_error(what),
        state_(std::make_shared<const State>(State{std::move(answered), std::move(failed)})) {}

  [[nodiscard]] const std::vector<Answer>& answered() const { return state_->answered; }
  [[nodiscard]] const Failed& failed() const { return state_->failed; }

 private:
  struct State {
    std::vector<Answer> answered;
    Failed failed;
  };
  std::shared_ptr<const State> state_;  // exceptions are copied without throwing
};

/// Answers collisions in order, one answer each. Used by the thread that opened it alone.
class Session {
 public:
  using Solve = std::function<std::vector<Answer>(std::span<const Collision>)>;

  Session() = default;
  /// `close` ends what the session holds on to; empty where that is nothing.
  template <class F,
            class = std::enable_if_t<std::is_invocable_r_v<std::vector<Answer>, F&, std::span<const Collision>>>>
  // NOLINTNEXTLINE(google-explicit-constructor): a callable is a session
  Session(F solve, std::function<void()> close = {}) : solve_(std::move(solve)), close_(std::move(close)) {}

  [[nodiscard]] std::vector<Answer> operator()(std::span<const Collision> collisions) { return solve_(collisions); }

  /// Ends the session in an orderly way. Throws where the subject does not end as it should.
  void close() {
    if (close_) {
      close_();
    }
  }

 private:
  Solve solve_;
  std::function<void()> close_;
};

/// A solver under test.
struct Subject {
  std::string name;
  /// What the command line calls it, where that is not its name: "exec:PROGRAM ARG…".
  std::string specification = {};
  std::string summary = {};
  std::string version = {};  // of the engine; empty where it has none of its own
  Model model = Model::any;
  Precision precision = Precision::binary64;
  /// Whether its author claims that it is right. One that is kept because it fails is shown, and does not count.
  bool expected_to_pass = true;
  /// What the subject does not claim: "invariant", or "invariant@family" for one family.
  std::vector<std::string> deviates;
  /// Why the subject cannot be run here (an engine that is not installed); empty where it can.
  std::string absent;
  /// A session of its own for each thread. Empty where `absent` is not.
  std::function<Session()> open;
  /// Whether it shows the collision matrix with the outcome of each colliding contact that it solves by one.
  bool shows_collision_matrix = false;

  /// Whether it is a program that answers in text.
  [[nodiscard]] bool is_program() const { return !specification.empty(); }
};

}  // namespace carom
