// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <carom/properties/phenomena/measure.hpp>

namespace carom::properties {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// A reading of a run, and the relative error that rounding explains.
struct Read {
  Reading reading;
  double rounding;
};

/// The reads of one reading.
struct Reads {
  MeasuredReading measured;
  std::map<double, std::vector<Read>> of_step;
};

template <class F>
std::vector<double> each(const std::vector<Read>& reads, F f) {
  std::vector<double> values(reads.size());
  std::transform(reads.begin(), reads.end(), values.begin(), f);
  return values;
}

double shift(const Reading& reading) { return (reading.measured - reading.right) / reading.scale; }

Rung rung_of(double step, const std::vector<Read>& reads) {
  const auto errors = each(reads, [](const Read& read) { return std::abs(shift(read.reading)); });
  const auto worths = each(reads, [](const Read& read) {
    const Reading& one = read.reading;
    return one.step_worth > 0 ? std::abs(one.measured - one.right) / one.step_worth : 0.0;
  });
  const auto roundings = each(reads, [](const Read& read) { return read.rounding; });
  return {step,
          static_cast<unsigned>(errors.size()),
          *std::min_element(errors.begin(), errors.end()),
          median(errors),
          *std::max_element(errors.begin(), errors.end()),
          median(worths),
          *std::max_element(worths.begin(), worths.end()),
          *std::max_element(roundings.begin(), roundings.end()),
          median(each(reads, [](const Read& read) { return read.reading.right / read.reading.scale; })),
          median(each(reads, [](const Read& read) { return shift(read.reading); }))};
}

/// The rungs are in the order of the ladder.
MeasuredReading gathered(const Reads& reads, const std::vector<double>& steps) {
  MeasuredReading measured = reads.measured;
  for (const double step : steps) {
    if (const auto here = reads.of_step.find(step); here != reads.of_step.end()) {
      measured.rungs.push_back(rung_of(step, here->second));
    }
  }
  measured.order = fitted_order(measured.rungs);
  return measured;
}

/// The relative error of a reading that rounding explains: that of the answer, and one rounding of the state a step.
double rounding_of(const Reading& reading, const Stepping& stepping, Precision precision) {
  const double size = std::max(std::abs(reading.right), reading.scale);
  return (reading.bound + static_cast<double>(steps_of(stepping)) * unit_roundoff(precision) * size) / reading.scale;
}

void note(std::vector<Unanswered>& all, const std::string& why, bool is_failure, double step) {
  auto place = std::find_if(all.begin(), all.end(), [&](const Unanswered& one) { return one.why == why; });
  if (place == all.end()) {
    place = all.insert(all.end(), {why, is_failure, {}});
  }
  place->steps.push_back(step);
}

bool is_finite(const BodyState& state) {
  return state.position.allFinite() && state.orientation.allFinite() && state.velocity.allFinite() &&
         state.angular_velocity.allFinite();
}

/// Failed if states are missing, or if a number is not finite.
SteppingAnswer checked(SteppingAnswer answer, const Stepping& stepping) {
  if (const auto* const answered = std::get_if<SteppedStates>(&answer)) {
    const auto& all = answered->states;
    if (all.size() != stepping.report.size() || !std::all_of(all.begin(), all.end(), [&](const auto& states) {
          return states.size() == stepping.scene.bodies.size();
        })) {
      return Failed{"the answer has not a state for each body at each time"};
    }
    if (!std::all_of(all.begin(), all.end(),
                     [](const auto& states) { return std::all_of(states.begin(), states.end(), is_finite); })) {
      return Failed{"a state has an infinity or NaN"};
    }
  }
  return answer;
}

bool is_in(const SteppedScene& scene, std::string_view what) {
  constexpr std::string_view shapes[] = {"sphere", "box", "half_space"};  // in the order of `Shape`
  return (what == "friction" && scene.friction > 0) || (what == "continuous" && scene.is_continuous) ||
         std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [&](const SteppedBody& body) { return shapes[body.shape.index()] == what; });
}

}  // namespace

std::variant<SteppedStates, NoAnswer> answer_of(const Stepper& stepper, Stepper::Session& session,
                                                const Stepping& stepping) {
  const auto found = std::find_if(stepper.cannot.begin(), stepper.cannot.end(),
                                  [&](const std::string& what) { return is_in(stepping.scene, what); });
  if (found != stepper.cannot.end()) {
    return NoAnswer{"the subject cannot pose: " + *found};
  }
  SteppingAnswer answer = checked(session(stepping), stepping);
  if (const auto* skipped = std::get_if<Skipped>(&answer)) {
    return NoAnswer{skipped->why};
  }
  if (const auto* refused = std::get_if<Refused>(&answer)) {
    return NoAnswer{"refused: " + refused->why};
  }
  if (const auto* failed = std::get_if<Failed>(&answer)) {
    return NoAnswer{failed->why, true};
  }
  return std::get<SteppedStates>(std::move(answer));
}

Stepper::Session patient(Stepper::Session session, std::stop_token stop,
                         std::function<void(const std::string& why)> on_failure, double lost) {
  using Clock = std::chrono::steady_clock;
  constexpr double most_lost = 180;  // [s]: a program that always hangs would take hours
  return [=](const Stepping& stepping) mutable -> SteppingAnswer {
    if (!stop.stop_requested() && lost >= most_lost) {
      return Skipped{"runs that failed took three minutes before"};
    }
    const Clock::time_point start = Clock::now();
    SteppingAnswer answer = stop.stop_requested() ? Skipped{} : checked(session(stepping), stepping);
    const auto* const failed = std::get_if<Failed>(&answer);
    lost += failed == nullptr ? 0 : std::chrono::duration<double>(Clock::now() - start).count();
    if (stop.stop_requested()) {
      return Skipped{"the measurement was interrupted"};
    }
    if (failed != nullptr) {
      on_failure(failed->why);
    }
    return answer;
  };
}

std::optional<double> fitted_order(std::span<const Rung> rungs) {
  std::vector<std::pair<double, double>> points;
  for (const Rung& rung : rungs) {
    if (rung.median > rung.rounding) {
      points.emplace_back(std::log(rung.step), std::log(rung.median));
    }
  }
  if (points.size() < 3) {
    return std::nullopt;
  }
  double x = 0;
  double y = 0;
  for (const auto& point : points) {
    x += point.first / static_cast<double>(points.size());
    y += point.second / static_cast<double>(points.size());
  }
  double xx = 0;
  double xy = 0;
  for (const auto& point : points) {
    xx += (point.first - x) * (point.first - x);
    xy += (point.first - x) * (point.second - y);
  }
  return xy / xx;
}

Measurement measure(const Phenomenon& phenomenon, const Stepper& stepper, Stepper::Session& session,
                    const Ladder& ladder) {
  Measurement result{std::string(phenomenon.name), phenomenon.version, {}, {}, {}, 0};
  std::vector<Reads> all;
  std::map<double, std::vector<double>> seconds;  // of a step
  constexpr unsigned most_failures = 3;
  unsigned failures = 0;
  const std::vector<PosedRun> runs = phenomenon.runs(ladder, stepper.is_planar);
  for (const PosedRun& run : runs) {
    ++result.runs;
    const auto answer = failures == most_failures ? NoAnswer{"the subject failed three times before"}
                                                  : answer_of(stepper, session, run.stepping);
    if (const auto* none = std::get_if<NoAnswer>(&answer)) {
      failures += none->is_failure ? 1 : 0;
      note(result.unanswered, none->why, none->is_failure, run.stepping.step);
      continue;
    }
    failures = 0;
    const auto& states = std::get<SteppedStates>(answer);
    seconds[run.stepping.step].push_back(states.seconds / static_cast<double>(steps_of(run.stepping)));
    for (Reading& reading : run.read(states)) {
      if (!std::isfinite(shift(reading))) {
        note(result.unanswered, "no number can be read off the states: " + reading.what, true, run.stepping.step);
        continue;
      }
      const double rounding = rounding_of(reading, run.stepping, stepper.precision);
      auto reads =
          std::find_if(all.begin(), all.end(), [&](const Reads& one) { return one.measured.what == reading.what; });
      if (reads == all.end()) {
        reads = all.insert(all.end(), Reads{{reading.what, reading.unit, {}, {}}, {}});
      }
      reads->of_step[run.stepping.step].push_back({std::move(reading), rounding});
    }
  }
  std::transform(all.begin(), all.end(), std::back_inserter(result.readings),
                 [&](const Reads& reads) { return gathered(reads, ladder.steps); });
  for (const double step : ladder.steps) {
    if (std::none_of(runs.begin(), runs.end(), [&](const PosedRun& run) { return run.stepping.step == step; })) {
      ++result.runs;
      note(result.unanswered, runs.empty() ? "it has no set-up in the plane" : "it is measured at longer steps alone",
           false, step);
    }
    if (const auto found = seconds.find(step); found != seconds.end()) {
      result.step_times.push_back({step, median(found->second)});
    }
  }
  return result;
}

}  // namespace carom::properties
