// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <carom/report/pictures/time_pictures.hpp>

namespace carom::report {
namespace {

using properties::Measurement;
using properties::Rung;

constexpr double left_pixel = 90;
constexpr double right_pixel = 690;
constexpr std::string_view as_shipped = "-as-shipped";
constexpr std::array line_colours{blue, vermillion, green, purple, orange, sky_blue, black, grey};

bool is_shipped_twin(const TimedEngine& engine, const TimeRun& run) {
  return engine.name.ends_with(as_shipped) &&
         std::any_of(run.engines.begin(), run.engines.end(),
                     [&](const TimedEngine& other) { return other.name + std::string(as_shipped) == engine.name; });
}

using Points = std::vector<std::vector<double>>;

/// An engine's errors along the ladder.
struct Line {
  std::string name;
  std::size_t style;  // the same in all pictures of a run
  Points points;
};

/// The lines with at least two points. `abscissa` is of a step; a step at 0 has no point.
std::vector<Line> lines_of(const properties::Phenomenon& phenomenon, const TimeRun& run,
                           double (*abscissa)(const properties::StepTime& time)) {
  std::vector<Line> lines;
  std::size_t style = 0;
  for (const TimedEngine& engine : run.engines) {
    if (is_shipped_twin(engine, run)) {
      continue;
    }
    Line line{engine.name, style++, {}};
    const Measurement* const measurement = measurement_of(engine, phenomenon.name);
    if (measurement == nullptr) {
      continue;
    }
    for (const properties::StepTime& time : measurement->step_times) {
      const properties::MeasuredReading* const worst = worst_reading(*measurement, time.step);
      const Rung* const rung = worst == nullptr ? nullptr : rung_at(*worst, time.step);
      if (rung != nullptr && rung->median > rung->rounding && abscissa(time) > 0) {
        line.points.push_back({abscissa(time), rung->median});
      }
    }
    if (line.points.size() > 1) {
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

/// An axis of whole powers of ten around the values.
Axis axis_around(const std::vector<Line>& lines, std::size_t coordinate, double first_pixel, double last_pixel) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  for (const Line& line : lines) {
    for (const std::vector<double>& point : line.points) {
      low = std::min(low, point[coordinate]);
      high = std::max(high, point[coordinate]);
    }
  }
  const double first = std::floor(std::log10(low));
  return {std::pow(10, first), std::pow(10, std::max(first + 1, std::ceil(std::log10(high)))), true, first_pixel,
          last_pixel};
}

/// A tic with its number at each of these steps in a second.
std::string tics_at(const std::vector<double>& numbers) {
  std::string tics;
  for (const double number : numbers) {
    tics += fmt::format("{0}\"{1:.4g}\" {1:.8g}", tics.empty() ? "" : ", ", number);
  }
  return "set xtics (" + tics + ")";
}

/// The numbers of steps in a second that have a point, ascending.
std::vector<double> steps_of(const std::vector<Line>& lines) {
  std::set<double> steps;
  for (const Line& line : lines) {
    for (const std::vector<double>& point : line.points) {
      steps.insert(point[0]);
    }
  }
  return {steps.begin(), steps.end()};
}

Plot picture_of(const std::string& name, const std::string& title, const std::string& x_name,
                const std::vector<Line>& lines, const Axis& x, const std::string& x_tics) {
  Plot plot(name, 860, 430, 13);
  const Panel panel{x, axis_around(lines, 1, 55, 390)};
  plot.begin(panel, title, x_name, "error, relative to the known answer");
  plot.add(x_tics);
  plot.add(power_tics(panel.y, 'y'));
  std::vector<Label> ends;
  for (const Line& line : lines) {
    const std::vector<double>& end = line.points.back();
    ends.push_back(
        {line.name, panel.place_of(end[0], end[1]), std::string(line_colours[line.style % line_colours.size()])});
  }
  plot.name_ends(ends, panel);
  for (const Line& line : lines) {
    plot.curve(line.points, fmt::format("with linespoints pt 7 ps 0.5 lw 1.6 lc rgb \"{}\"{}",
                                        line_colours[line.style % line_colours.size()],
                                        line.style < line_colours.size() ? "" : " dt 2"));
  }
  plot.end();
  return plot;
}

struct Bar {
  std::string name;
  double height;  // over the height of the fall
  double known;
};

std::vector<Bar> first_bounces(const TimeRun& run) {
  std::vector<Bar> bars;
  for (const TimedEngine& engine : run.engines) {
    const Measurement* const measurement = measurement_of(engine, "bounce");
    if (measurement == nullptr) {
      continue;
    }
    for (const properties::MeasuredReading& reading : measurement->readings) {
      const Rung* const rung = rung_at(reading, compared_step(run.ladder));
      if (reading.what == "height of bounce 1, ε = 0.5" && rung != nullptr) {
        bars.push_back({engine.name, rung->expected + rung->shift, rung->expected});
      }
    }
  }
  return bars;
}

}  // namespace

std::vector<Plot> time_pictures(const properties::Phenomenon& phenomenon, const TimeRun& run) {
  std::vector<Plot> pictures;
  const std::string name(phenomenon.name);
  const std::vector<Line> by_step =
      lines_of(phenomenon, run, [](const properties::StepTime& time) { return 1 / time.step; });
  if (!by_step.empty()) {
    const std::vector<double> steps = steps_of(by_step);
    pictures.push_back(picture_of(name + "-step", name + ": error against the step", "steps in a second", by_step,
                                  {0.8 * steps.front(), 1.25 * steps.back(), true, left_pixel, right_pixel},
                                  tics_at(steps)));
  }
  // The simulation of `carom scene` has no steps, and so takes no time for one.
  const std::vector<Line> by_time =
      lines_of(phenomenon, run, [](const properties::StepTime& time) { return time.seconds / time.step; });
  if (!by_time.empty()) {
    const Axis x = axis_around(by_time, 0, left_pixel, right_pixel);
    pictures.push_back(picture_of(name + "-time", name + ": error against the time spent",
                                  "seconds of stepping for a second of the scene", by_time, x, power_tics(x, 'x')));
  }
  return pictures;
}

std::vector<Plot> first_bounce_picture(const TimeRun& run) {
  const std::vector<Bar> bars = first_bounces(run);
  if (bars.empty()) {
    return {};
  }
  double highest = 0;
  for (const Bar& bar : bars) {
    highest = std::max({highest, bar.height, bar.known});
  }
  const auto count = static_cast<double>(bars.size());
  constexpr double below = 60;
  constexpr double each = 20;
  Plot plot("first-bounce", 860, below + 45 + each * count, 13);
  const Panel panel{{0, 1.15 * highest, false, 170, 830}, {0, count, false, below, below + each * count}};
  plot.begin(panel, fmt::format("First bounce with ε = 1/2 at {:.3g} steps in a second", 1 / compared_step(run.ladder)),
             "height of the bounce / height of the fall; the line is the known answer", "");
  plot.add("unset ytics");
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double y = count - static_cast<double>(i) - 0.5;
    const auto beside = [&](double x, double pixels) {
      const Pixel place = panel.place_of(x, y);
      return Pixel{place.x + pixels, place.y};
    };
    plot.write(bars[i].name, beside(0, -8), "#000000", "right");
    plot.write(fmt::format("{:.3f}", bars[i].height), beside(std::max(bars[i].height, bars[i].known), 6));
    plot.curve({{0, y, std::max(bars[i].height, 0.0), y}},
               fmt::format("using 1:2:($3-$1):($4-$2) with vectors nohead lw 11 lc rgb \"{}\"",
                           bars[i].name.ends_with(as_shipped) ? sky_blue : blue));
  }
  plot.curve({{bars[0].known, 0}, {bars[0].known, count}}, fmt::format("with lines lw 2 lc rgb \"{}\"", vermillion));
  plot.end();
  return {plot};
}

}  // namespace carom::report
