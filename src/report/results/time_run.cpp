// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <carom/collision/json/json.hpp>
#include <carom/report/results/time_run.hpp>

namespace carom::report {
namespace {

using nlohmann::json;

template <class T, class F>
json records(const std::vector<T>& all, F record) {
  json array = json::array();
  std::transform(all.begin(), all.end(), std::back_inserter(array), record);
  return array;
}

json rung_record(const properties::Rung& rung) {
  return {{"step", rung.step},
          {"answers", rung.answers},
          {"least", number_to_json(rung.least)},
          {"median", number_to_json(rung.median)},
          {"greatest", number_to_json(rung.greatest)},
          {"median_in_step_worths", number_to_json(rung.median_in_worths)},
          {"greatest_in_step_worths", number_to_json(rung.greatest_in_worths)},
          {"rounding", number_to_json(rung.rounding)},
          {"shift", number_to_json(rung.shift)}};
}

json reading_record(const properties::MeasuredReading& reading) {
  json record{{"what", reading.what}, {"unit", reading.unit}, {"rungs", records(reading.rungs, rung_record)}};
  if (reading.order) {
    record["order"] = number_to_json(*reading.order);
  }
  return record;
}

json measurement_record(const properties::Measurement& measurement) {
  const auto of_time = [](const properties::StepTime& time) {
    return json{{"step", time.step}, {"seconds", number_to_json(time.seconds)}};
  };
  const auto of_unanswered = [](const properties::Unanswered& one) {
    return json{{"why", one.why}, {"failure", one.is_failure}, {"runs", one.steps.size()}};
  };
  return {{"phenomenon", measurement.phenomenon},
          {"version", measurement.version},
          {"runs", measurement.runs},
          {"readings", records(measurement.readings, reading_record)},
          {"seconds_for_a_step", records(measurement.step_times, of_time)},
          {"unanswered", records(measurement.unanswered, of_unanswered)}};
}

json relation_record(const properties::RelationResult& relation) {
  return {{"name", relation.name}, {"change", relation.change}, {"result", properties::in_words(relation)}};
}

json claim_record(const JudgedClaim& one) {
  return {{"claim", one.claim},
          {"judged", one.is_judged},
          {"kept", one.verdict.is_kept},
          {"greatest", number_to_json(one.verdict.greatest)},
          {"why", one.verdict.why}};
}

json engine_record(const TimedEngine& engine) {
  json record{{"name", engine.name}, {"version", engine.version}, {"precision", name_of(engine.precision)}};
  if (!engine.specification.empty()) {
    record["specification"] = engine.specification;
  }
  if (!engine.absent.empty()) {
    record["absent"] = engine.absent;
    return record;
  }
  record["seconds"] = engine.seconds;
  record["measurements"] = records(engine.measurements, measurement_record);
  record["relations"] = records(engine.relations, relation_record);
  record["claims"] = records(engine.claims, claim_record);
  return record;
}

}  // namespace

bool TimedEngine::is_measured() const {
  return std::any_of(measurements.begin(), measurements.end(),
                     [](const properties::Measurement& one) { return !one.readings.empty(); }) ||
         std::any_of(relations.begin(), relations.end(), [](const properties::RelationResult& one) {
           return one.likeness != properties::Likeness::unanswered;
         });
}

bool TimedEngine::has_failed() const {
  const auto is_failure = [](const auto& one) { return one.is_failure; };
  return std::any_of(relations.begin(), relations.end(), is_failure) ||
         std::any_of(measurements.begin(), measurements.end(), [&](const properties::Measurement& one) {
           return std::any_of(one.unanswered.begin(), one.unanswered.end(), is_failure);
         });
}

int TimeRun::exit_status() const {
  const auto measured =
      std::count_if(engines.begin(), engines.end(), [](const TimedEngine& one) { return one.is_measured(); });
  const bool is_any_unjudged = std::any_of(engines.begin(), engines.end(), [](const TimedEngine& engine) {
    return !engine.claims.empty() && std::none_of(engine.claims.begin(), engine.claims.end(),
                                                  [](const JudgedClaim& one) { return one.is_judged; });
  });
  if (interrupted || measured == 0 || is_any_unjudged || (are_named && measured < std::ssize(engines))) {
    return exit_usage;
  }
  const bool is_any_at_fault = std::any_of(engines.begin(), engines.end(), [&](const TimedEngine& engine) {
    return (are_named && engine.has_failed()) ||
           std::any_of(engine.claims.begin(), engine.claims.end(),
                       [](const JudgedClaim& one) { return one.is_judged && !one.verdict.is_kept; });
  });
  return is_any_at_fault ? exit_violated : exit_all_hold;
}

const properties::Measurement* measurement_of(const TimedEngine& engine, std::string_view phenomenon) {
  const auto found = std::find_if(engine.measurements.begin(), engine.measurements.end(),
                                  [&](const properties::Measurement& one) { return one.phenomenon == phenomenon; });
  return found == engine.measurements.end() ? nullptr : &*found;
}

const properties::Rung* rung_at(const properties::MeasuredReading& reading, double step) {
  const auto found = std::find_if(reading.rungs.begin(), reading.rungs.end(),
                                  [&](const properties::Rung& rung) { return rung.step == step; });
  return found == reading.rungs.end() ? nullptr : &*found;
}

const properties::MeasuredReading* worst_reading(const properties::Measurement& measurement, double step) {
  std::size_t most = 0;
  for (const properties::MeasuredReading& reading : measurement.readings) {
    most = std::max(most, reading.rungs.size());
  }
  const auto is_less = [](const properties::Rung& x, const properties::Rung& y) {
    return std::pair(x.median > x.rounding, x.median) < std::pair(y.median > y.rounding, y.median);
  };
  const properties::MeasuredReading* worst = nullptr;
  for (const properties::MeasuredReading& reading : measurement.readings) {
    const properties::Rung* const rung = rung_at(reading, step);
    if (rung != nullptr && reading.rungs.size() == most &&
        (worst == nullptr || is_less(*rung_at(*worst, step), *rung))) {
      worst = &reading;
    }
  }
  return worst;
}

double compared_step(const properties::Ladder& ladder) {
  const auto apart = [](double step) { return std::abs(std::log(step * 60)); };
  return *std::min_element(ladder.steps.begin(), ladder.steps.end(),
                           [&](double x, double y) { return apart(x) < apart(y); });
}

nlohmann::json time_record(const TimeRun& run) {
  return {{"carom", version},
          {"date", run.environment.date},
          {"processor", run.environment.processor},
          {"exit_status", run.exit_status()},
          {"interrupted", run.interrupted},
          {"steps", run.ladder.steps},
          {"phases", run.ladder.phases},
          {"engines", records(run.engines, engine_record)}};
}

}  // namespace carom::report
