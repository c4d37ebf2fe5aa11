// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/phenomena/measure.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace carom::properties {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// The readings of one `what` at one step.
struct Gathered {
  std::vector<Reading> readings;
  double rounding = 0;
};

template <class F>
std::vector<double> each(const std::vector<Reading>& readings, F f) {
  std::vector<double> values(readings.size());
  std::transform(readings.begin(), readings.end(), values.begin(), f);
  return values;
}

Rung rung_of(double step, const Gathered& gathered) {
  const auto shift = each(gathered.readings, [](const Reading& r) { return (r.measured - r.right) / r.scale; });
  const auto errors = each(gathered.readings, [](const Reading& r) { return std::abs(r.measured - r.right) / r.scale; });
  const auto worths = each(gathered.readings, [](const Reading& r) {
    return r.step_worth > 0 ? std::abs(r.measured - r.right) / r.step_worth : 0.0;
  });
  const auto expected = each(gathered.readings, [](const Reading& r) { return r.right / r.scale; });
  return {step,
          static_cast<unsigned>(errors.size()),
          *std::min_element(errors.begin(), errors.end()),
          median(errors),
          *std::max_element(errors.begin(), errors.end()),
          median(worths),
          *std::max_element(worths.begin(), worths.end()),
          gathered.rounding,
          median(expected),
          median(shift)};
}

/// The relative error of a reading that rounding explains: that of the answer, and one rounding of the state a step.
double rounding_of(const Reading& reading, const Stepping& stepping, Precision precision) {
  const double size = std::max(std::abs(reading.right), reading.scale);
  return (reading.bound + static_cast<double>(steps_of(stepping)) * unit_roundoff(precision) * size) / reading.scale;
}

/// Collects the answers to all runs.
class Gathering {
 public:
  explicit Gathering(const Ladder& ladder) : steps_(ladder.steps) {}

  void add(const PosedRun& run, const SteppedStates& states, Precision precision) {
    times_[run.step].push_back(states.seconds / static_cast<double>(steps_of(run.stepping)));
    for (const Reading& reading : run.read(states)) {
      auto place = std::find_if(all_.begin(), all_.end(), [&](const One& one) { return one.what == reading.what; });
      if (place == all_.end()) {
        place = all_.insert(all_.end(), {reading.what, reading.unit, {}});
      }
      Gathered& gathered = place->at[run.step];
      gathered.readings.push_back(reading);
      gathered.rounding = std::max(gathered.rounding, rounding_of(reading, run.stepping, precision));
    }
  }

  void finish(Measurement& measurement) const {
    for (const One& one : all_) {
      MeasuredReading reading{one.what, one.unit, {}, {}};
      for (const double step : steps_) {
        if (const auto found = one.at.find(step); found != one.at.end()) {
          reading.rungs.push_back(rung_of(step, found->second));
        }
      }
      reading.order = fitted_order(reading.rungs);
      measurement.readings.push_back(std::move(reading));
    }
    for (const double step : steps_) {
      if (const auto found = times_.find(step); found != times_.end()) {
        measurement.step_times.push_back({step, median(found->second)});
      }
    }
  }

 private:
  struct One {
    std::string what;
    std::string unit;
    std::map<double, Gathered> at;
  };

  std::vector<double> steps_;
  std::vector<One> all_;
  std::map<double, std::vector<double>> times_;
};

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

std::string_view shape_name(const Shape& shape) {
  return std::holds_alternative<SphereShape>(shape) ? "sphere"
         : std::holds_alternative<BoxShape>(shape)  ? "box"
                                                    : "half_space";
}

}  // namespace

std::optional<std::string> why_not_posed(const Stepper& stepper, const SteppedScene& scene) {
  const auto is_needed = [&](const std::string& what) {
    return (what == "friction" && scene.friction > 0) || (what == "continuous" && scene.is_continuous) ||
           std::any_of(scene.bodies.begin(), scene.bodies.end(),
                       [&](const SteppedBody& body) { return shape_name(body.shape) == what; });
  };
  const auto found = std::find_if(stepper.cannot.begin(), stepper.cannot.end(), is_needed);
  return found == stepper.cannot.end() ? std::nullopt : std::optional("the subject cannot pose: " + *found);
}

SteppingAnswer checked(SteppingAnswer answer, const Stepping& stepping) {
  const auto* states = std::get_if<SteppedStates>(&answer);
  if (states == nullptr) {
    return answer;
  }
  const std::size_t bodies = stepping.scene.bodies.size();
  if (states->states.size() != stepping.report.size() ||
      std::any_of(states->states.begin(), states->states.end(), [&](const auto& all) { return all.size() != bodies; })) {
    return Failed{"the answer has not a state for each body at each time"};
  }
  if (!std::all_of(states->states.begin(), states->states.end(),
                   [](const auto& all) { return std::all_of(all.begin(), all.end(), is_finite); })) {
    return Failed{"a state has an infinity or NaN"};
  }
  return answer;
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
  Gathering gathering(ladder);
  constexpr unsigned most_failures = 3;
  unsigned failures = 0;
  for (const PosedRun& run : phenomenon.runs(ladder, stepper.is_planar)) {
    ++result.runs;
    if (failures == most_failures) {
      note(result.unanswered, "the subject failed three times before", false, run.step);
      continue;
    }
    if (const auto why = why_not_posed(stepper, run.stepping.scene)) {
      note(result.unanswered, *why, false, run.step);
      continue;
    }
    const SteppingAnswer answer = checked(session(run.stepping), run.stepping);
    const auto* failed = std::get_if<Failed>(&answer);
    failures = failed != nullptr ? failures + 1 : 0;
    if (failed != nullptr) {
      note(result.unanswered, failed->why, true, run.step);
    } else if (const auto* skipped = std::get_if<Skipped>(&answer)) {
      note(result.unanswered, skipped->why, false, run.step);
    } else if (const auto* refused = std::get_if<Refused>(&answer)) {
      note(result.unanswered, "refused: " + refused->why, false, run.step);
    } else {
      gathering.add(run, std::get<SteppedStates>(answer), stepper.precision);
    }
  }
  gathering.finish(result);
  return result;
}

}  // namespace carom::properties
