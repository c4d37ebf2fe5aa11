// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <carom/collision/expects.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/subjects/protocol/child.hpp>
#include <carom/subjects/protocol/command_line.hpp>
#include <carom/subjects/protocol/exec_stepper.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/subjects/protocol/stepping_messages.hpp>

namespace carom::subjects::protocol {
namespace {

constexpr std::size_t longest_reason_shown = 2000;  // bytes

/// The longest line of a reply: it has the states of some twenty bodies at some hundred times.
constexpr std::size_t longest_reply = std::size_t{1} << 24U;  // bytes

/// A started program that steps.
class SteppingProgram {
 public:
  SteppingProgram(const std::vector<std::string>& words, const ExecOptions& options)
      : process_(words, options.limits, options.stop) {
    try {
      process_.exchange(start_request(), 1, [&](std::string_view line) { stepper_ = stepper_from(line); });
    } catch (const std::exception& error) {
      const std::string said = process_.standard_error();
      throw std::runtime_error(error.what() + (said.empty() ? said : "; standard error: " + said));
    }
  }

  [[nodiscard]] const Stepper& stepper() const { return stepper_; }

  [[nodiscard]] SteppingAnswer run(const Stepping& stepping) {
    return stepping.restored == 0 ? asked(stepping, run_request) : run_and_restored(stepping);
  }

  [[nodiscard]] std::string standard_error() { return process_.standard_error(); }

 private:
  [[nodiscard]] SteppingAnswer asked(const Stepping& stepping,
                                     std::string (*request)(std::uint64_t id, const Stepping& stepping)) {
    SteppingAnswer answer;
    const std::uint64_t id = next_id_++;
    process_.exchange(request(id, stepping), 1,
                      [&](std::string_view line) { answer = run_reply_from(line, id, stepping); });
    return answer;
  }

  /// The reason if the program does not save or restore.
  [[nodiscard]] std::optional<Refused> refusal(std::string_view command) {
    std::optional<Refused> refused;
    const std::uint64_t id = next_id_++;
    process_.exchange(state_request(id, command), 1,
                      [&](std::string_view line) { refused = state_reply_from(line, id); });
    return refused;
  }

  /// Runs to the end, and then once more from the state that was saved in between.
  [[nodiscard]] SteppingAnswer run_and_restored(const Stepping& stepping) {
    Stepping before = stepping;
    Stepping after = stepping;
    const auto rest = std::upper_bound(stepping.report.begin(), stepping.report.end(), stepping.restored);
    before.report.assign(stepping.report.begin(), rest);
    after.report.assign(rest, stepping.report.end());
    std::for_each(after.report.begin(), after.report.end(), [&](std::uint64_t& steps) { steps -= stepping.restored; });
    SteppingAnswer first = asked(before, run_request);
    if (!std::holds_alternative<SteppedStates>(first)) {
      return first;
    }
    SteppingAnswer second;
    for (const char* const command : {"save", "restore"}) {
      if (std::optional<Refused> refused = refusal(command)) {
        return *std::move(refused);
      }
      second = asked(after, continue_request);
      if (!std::holds_alternative<SteppedStates>(second)) {
        return second;
      }
    }
    auto& states = std::get<SteppedStates>(first);
    const auto& continued = std::get<SteppedStates>(second);
    states.states.insert(states.states.end(), continued.states.begin(), continued.states.end());
    states.seconds += continued.seconds;
    return first;
  }

  ChildProcess process_;
  Stepper stepper_;
  std::uint64_t next_id_ = 1;
};

/// Starts the program when it is first asked, and again after a failure.
Stepper::Session session_of(const std::vector<std::string>& words, const ExecOptions& options) {
  return [=, program = std::shared_ptr<SteppingProgram>()](const Stepping& stepping) mutable -> SteppingAnswer {
    try {
      if (program == nullptr) {
        program = std::make_shared<SteppingProgram>(words, options);
      }
      return program->run(stepping);
    } catch (const std::exception& error) {
      const std::string errors = program == nullptr ? "" : program->standard_error();
      program.reset();
      return Failed{printable_line(error.what(), longest_reason_shown), printable(errors, errors.size())};
    }
  };
}

}  // namespace

Stepper exec_stepper(const std::string& specification, const ExecOptions& options) {
  CAROM_EXPECTS(specification.starts_with(exec_prefix), specification);
  Stepper stepper;
  try {
    const std::vector<std::string> words = split_words(std::string_view(specification).substr(exec_prefix.size()));
    if (words.empty()) {
      throw std::invalid_argument("no program is given after exec:");
    }
    ExecOptions patient = options;
    patient.limits.line = longest_reply;
    stepper = SteppingProgram(words, patient).stepper();
    stepper.open = [words, patient] { return session_of(words, patient); };
  } catch (const std::exception& error) {
    stepper.name = specification;
    stepper.absent = printable_line(error.what(), longest_reason_shown);
  }
  stepper.specification = specification;
  return stepper;
}

}  // namespace carom::subjects::protocol
