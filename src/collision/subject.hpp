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

#include <carom/collision/declared_effects.hpp>
#include <carom/collision/law.hpp>
#include <carom/collision/precision.hpp>
#include <carom/collision/solved_outcome.hpp>

namespace carom {

/// The subject cannot solve this collision. A skip never passes.
struct Skipped {
  std::string why;
};

/// The subject refused the input. This is correct for an invalid collision and wrong for a valid one.
struct Refused {
  std::string why;
};

/// The subject gave no answer: it ended, hung, or wrote something that is not a reply.
struct Failed {
  std::string why;        // one line, the same each time the collision is solved
  std::string said = {};  // standard error and other text that helps to find the fault; may have several lines
};

using Answer = std::variant<ReportedOutcome, Skipped, Refused, Failed>;

/// A session cannot continue. The exception holds the answers before the failure, and the failure on the next
/// collision.
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
  std::shared_ptr<const State> state_;  // shared, so that copying the exception cannot throw
};

/// Answers collisions in order, one answer for each. Only the thread that opened a session may use it.
class Session {
 public:
  using Solve = std::function<std::vector<Answer>(std::span<const Collision>)>;

  Session() = default;
  /// `close` releases the resources of the session, and may be empty.
  template <class F,
            class = std::enable_if_t<std::is_invocable_r_v<std::vector<Answer>, F&, std::span<const Collision>>>>
  // NOLINTNEXTLINE(google-explicit-constructor): a callable is a session
  Session(F solve, std::function<void()> close = {}) : solve_(std::move(solve)), close_(std::move(close)) {}

  [[nodiscard]] std::vector<Answer> operator()(std::span<const Collision> collisions) { return solve_(collisions); }

  /// Ends the session. Throws if the subject does not end as it should.
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
  /// The subject's name on the command line, if it differs from `name`: "exec:PROGRAM ARG…".
  std::string specification = {};
  std::string summary = {};
  std::string version = {};  // of the engine; empty if it has no version of its own
  Law law = Law::any;
  Precision precision = Precision::binary64;
  /// Whether the author claims that the subject is correct. If not, the subject is judged and shown but does not count.
  bool expected_to_pass = true;
  /// The claims that the subject does not make: "invariant", or "invariant@family" for one family (random generator of
  /// collisions).
  std::vector<std::string> deviates;
  /// Why the subject cannot run here (an engine that is not installed); empty if it can.
  std::string absent;
  /// Opens a session; each thread opens its own. Empty if `absent` is not empty.
  std::function<Session()> open;
  /// Whether the subject reports its collision matrix for each colliding contact.
  bool shows_collision_matrix = false;
  /// The domain (a set of collisions) for which the subject is meant: "size=0.1:10,mass_ratio=:100". Empty for all
  /// collisions.
  std::string domain = {};
  /// What the subject does on purpose besides its law. The gate judges the rest.
  DeclaredEffects effects = {};
  /// The number of ways to write one collision for the subject. 1 if it reads bits, not decimals.
  unsigned spellings = 1;

  [[nodiscard]] bool is_program() const { return !specification.empty(); }
};

}  // namespace carom
