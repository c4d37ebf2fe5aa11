// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include <carom/properties/phenomena/phenomenon.hpp>

/// An engine measured on a phenomenon.
namespace carom::properties {

/// The errors of a reading at one step, over the phases. An error is |measured − right| / scale.
struct Rung {
  double step = 0;       // h [s]
  unsigned answers = 0;  // the phases that were answered
  double least = 0;
  double median = 0;
  double greatest = 0;
  double median_in_worths = 0;    // |measured − right| / step_worth; 0 if no error is explained
  double greatest_in_worths = 0;  // the same
  double rounding = 0;            // the greatest relative error that rounding explains
  double expected = 0;            // the median of right / scale
  double shift = 0;               // the median of (measured − right) / scale: > 0 if the engine has too much
};

struct MeasuredReading {
  std::string what;
  std::string unit;
  std::vector<Rung> rungs;      // in the order of the ladder; a step without an answer is missing
  std::optional<double> order;  // the error shrinks as this power of the step
};

struct StepTime {
  double step = 0;     // h [s]
  double seconds = 0;  // that the engine takes for one step: the median over the runs
};

/// Why a run has no states.
struct NoAnswer {
  std::string why;
  bool is_failure = false;  // otherwise the subject skipped or refused it, or was not asked
};

/// The states of a run. There are none if the stepper cannot pose the scene or gives no answer, if states are missing,
/// or if a number is not finite.
[[nodiscard]] std::variant<SteppedStates, NoAnswer> answer_of(const Stepper& stepper, Stepper::Session& session,
                                                              const Stepping& stepping);

/// Runs without an answer, for one reason.
struct Unanswered {
  std::string why;
  bool is_failure = false;    // as of `NoAnswer`
  std::vector<double> steps;  // of each run
};

struct Measurement {
  std::string phenomenon;
  unsigned version = 1;
  std::vector<MeasuredReading> readings;  // in the order in which they were first read
  std::vector<StepTime> step_times;
  std::vector<Unanswered> unanswered;
  unsigned runs = 0;  // posed, answered or not
};

/// The session, which skips each run after a request to stop, or once failed runs took three minutes. It calls
/// `on_failure` with the reason of each failure, at once.
[[nodiscard]] Stepper::Session patient(Stepper::Session session, std::stop_token stop,
                                       std::function<void(const std::string& why)> on_failure, double lost = 0);

/// Poses the runs of the phenomenon. After three failures one after the other, the other runs are not asked.
[[nodiscard]] Measurement measure(const Phenomenon& phenomenon, const Stepper& stepper, Stepper::Session& session,
                                  const Ladder& ladder);

/// The slope of log(median) over log(step), by least squares. Only rungs whose median is above rounding count. No value
/// if they are fewer than three.
[[nodiscard]] std::optional<double> fitted_order(std::span<const Rung> rungs);

}  // namespace carom::properties
