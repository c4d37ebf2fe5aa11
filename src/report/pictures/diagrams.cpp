// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <carom/oracles/judge/yardstick.hpp>
#include <carom/report/pictures/diagrams.hpp>
#include <carom/report/pictures/plot.hpp>

namespace carom::report {
namespace {

constexpr double most_digits = 21;  // an exact outcome has more digits; it is drawn here
constexpr double least_digits = 0;

constexpr std::pair<std::string_view, std::string_view> key_of_colours[] = {{"binary32", orange},
                                                                            {"binary64", blue},
                                                                            {"more than binary64", green},
                                                                            {"x: fails", vermillion},
                                                                            {"grey: Pareto line", grey}};

struct Mark {
  std::size_t number;  // of the method, from 0
  Spread nanoseconds;
  Quantiles digits;
  Precision precision;
  bool fails;
};

double drawn(double digits) { return std::clamp(digits, least_digits, most_digits); }

Axis time_axis(std::span<const MethodMeasurement> methods, double first_pixel, double last_pixel) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  for (const MethodMeasurement& method : methods) {
    for (const FamilyMeasurement& family : method.families) {
      low = std::min(low, family.nanoseconds.median);
      high = std::max(high, family.nanoseconds.median);
    }
  }
  return {low / 1.3, high * 1.3, true, first_pixel, last_pixel};
}

/// Draws bars, marks and the Pareto line, and labels for the marks with `is_labelled`.
template <class IsLabelled>
void draw(Plot& picture, const Panel& panel, const std::vector<Mark>& marks, double mark_size, double letter,
          const IsLabelled& is_labelled) {
  const std::vector<std::size_t> line = pareto(
      marks.size(), [&](std::size_t i) { return marks[i].nanoseconds.median; },
      [&](std::size_t i) { return drawn(marks[i].digits.median); }, [&](std::size_t i) { return !marks[i].fails; });
  std::vector<std::vector<double>> on_line;
  for (const std::size_t i : line) {
    on_line.push_back({marks[i].nanoseconds.median, drawn(marks[i].digits.median)});
  }
  picture.curve(on_line, "using 1:2 with steps lw 2 lc rgb '#bbbbbb'");
  std::vector<Label> labels;
  std::vector<Pixel> positions;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Mark& mark = marks[i];
    const double x = mark.nanoseconds.median;
    const double median = drawn(mark.digits.median);
    const std::string colour(colour_of(mark.precision));
    picture.curve({{x, drawn(mark.digits.worst), x, median}},
                  fmt::format("using 1:2:($3-$1):($4-$2) with vectors nohead lw 1.2 lc rgb '{}'", colour));
    if (mark.fails) {
      picture.curve({{x, median}},
                    fmt::format("using 1:2 with points pt 2 ps {} lw 2.5 lc rgb '{}'", mark_size * 1.3, vermillion));
    } else {
      picture.curve({{x, median}}, fmt::format("using 1:2 with points pt 7 ps {} lc rgb '{}'", mark_size, colour));
    }
    positions.push_back(panel.place_of(x, median));
    const bool is_on_line = std::find(line.begin(), line.end(), i) != line.end();
    if (is_labelled(mark, is_on_line)) {
      labels.push_back(
          {std::to_string(mark.number + 1), positions.back(), mark.fails ? std::string(vermillion) : colour});
    }
  }
  place_labels(labels, positions, letter, panel);
  picture.write(labels, letter);
}

constexpr double line_height = 21;     // of the list of methods
constexpr std::size_t rows_below = 3;  // the names of the columns, and the key

std::size_t rows_of(std::span<const MethodMeasurement> methods) { return (methods.size() + 1) / 2; }

/// Writes the list of methods in two columns below the diagram: number, name, time, digits, and the number of families
/// in which it fails.
void write_list(Plot& picture, std::span<const MethodMeasurement> methods) {
  const double top = line_height * static_cast<double>(rows_of(methods) + rows_below) - 5;
  const auto line = [&](double left, double y, const std::array<std::string, 5>& cells, std::string_view colour) {
    picture.write(cells[0], {left + 22, y}, colour, "right");
    picture.write(cells[1], {left + 30, y}, colour);
    picture.write(cells[2], {left + 365, y}, colour, "right");
    picture.write(cells[3], {left + 415, y}, colour, "right");
    picture.write(cells[4], {left + 485, y}, colour, "right");
  };
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const MethodMeasurement& method = methods[i];
    const auto failing = std::count_if(method.families.begin(), method.families.end(),
                                       [](const FamilyMeasurement& family) { return family.exactness.failures > 0; });
    const double left = i < rows_of(methods) ? 10 : 510;
    const std::size_t place = i % rows_of(methods);
    if (place == 0) {
      line(left, top, {"", "method", "ns", "digits", "fails in"}, "#555555");
    }
    line(left, top - line_height * static_cast<double>(place + 1),
         {std::to_string(i + 1), method.name, in_three_digits(method.nanoseconds_over_all_families().median),
          fmt::format("{:.1f}", std::min(method.over_all_families().digits.median, most_digits)),
          failing > 0 ? fmt::format("{} of {}", failing, method.families.size()) : ""},
         failing > 0 ? vermillion : colour_of(method.precision));
  }
  double x = 40;
  for (const auto& [text, colour] : std::span(key_of_colours).first<3>()) {
    picture.write(text, {x, line_height + 10}, colour);
    x += 100;
  }
  picture.write("mark: median case · bar: down to the worst case · grey: Pareto line", {x + 70, line_height + 10},
                "#555555");
  picture.write(
      fmt::format("× fails: beyond the limit of {:g} ulps in some case of a family", oracles::default_limit_ulps),
      {40, 10}, vermillion);
}

constexpr double least_error = 0.01;
constexpr double most_error = 1e22;  // errors that are not finite are drawn here too

struct Style {
  std::string_view colour;
  int dash;
  int point;
};

/// The colour shows the precision. Methods of one precision differ in dash and mark.
Style style_of(const SweepLine& line, std::size_t index) {
  constexpr std::array points{7, 5, 9, 13, 11, 4, 6};
  return {colour_of(line.precision), static_cast<int>(index / points.size() % 4) + 1, points[index % points.size()]};
}

std::vector<std::vector<double>> points_of(const SweepLine& line) {
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < line.quantity.size(); ++i) {
    if (line.exactness[i].cases > 0) {
      points.push_back({line.quantity[i], std::clamp(line.exactness[i].backward_error.worst, least_error, most_error)});
    }
  }
  return points;
}

double share_with(const MethodMeasurement& method, double digits) {
  const Exactness all = method.over_all_families();
  const auto enough = std::count_if(all.digits_of_cases.begin(), all.digits_of_cases.end(),
                                    [&](double of_case) { return of_case >= digits; });
  return static_cast<double>(enough) / static_cast<double>(all.digits_of_cases.size());
}

}  // namespace

std::vector<MethodMeasurement> of_law(std::span<const MethodMeasurement> methods, Law law) {
  std::vector<MethodMeasurement> result;
  for (const MethodMeasurement& method : methods) {
    if (method.law == law) {
      result.push_back(method);
    }
  }
  return result;
}

Plot work_precision(std::span<const MethodMeasurement> methods) {
  const std::string law(name_of(methods.front().law));
  const double bottom = line_height * static_cast<double>(rows_of(methods) + rows_below) + 80;
  Plot picture("work-precision-" + law, 1000, bottom + 620, 14);
  const Panel panel{time_axis(methods, 70, 980), {least_digits, most_digits + 0.5, false, bottom, bottom + 580}};
  picture.begin(panel, fmt::format("{}: time against accuracy, all families", law), "time for each contact [ns]",
                "correct digits of the change of velocities");
  picture.add(time_tics(panel.x) + "\nset ytics 3");
  std::vector<Mark> marks;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    marks.push_back({i, methods[i].nanoseconds_over_all_families(), methods[i].over_all_families().digits,
                     methods[i].precision, methods[i].fails()});
  }
  draw(picture, panel, marks, 0.8, 14, [](const Mark&, bool) { return true; });
  write_list(picture, methods);
  picture.end();
  return picture;
}

Plot work_precision_of_families(std::span<const MethodMeasurement> methods) {
  const std::string law(name_of(methods.front().law));
  const std::size_t count = methods.front().families.size();
  constexpr std::size_t columns = 3;
  const std::size_t rows = (count + columns - 1) / columns;
  constexpr double cell_width = 500;
  constexpr double cell_height = 370;
  const double height = cell_height * static_cast<double>(rows) + 110;
  Plot picture("work-precision-" + law + "-families", columns * cell_width, height, 20);
  for (std::size_t f = 0; f < count; ++f) {
    const double left = cell_width * static_cast<double>(f % columns);
    const std::size_t row = f / columns;
    const double bottom = height - 100 - cell_height * static_cast<double>(row + 1);
    const Panel panel{time_axis(methods, left + 75, left + cell_width - 20),
                      {least_digits, most_digits + 0.5, false, bottom + 100, bottom + cell_height - 40}};
    picture.begin(panel, methods.front().families[f].family, f + columns >= count ? "time for each contact [ns]" : "",
                  f % columns == 0 ? "correct digits" : "");
    picture.add(time_tics(panel.x));
    picture.add("set ytics 6");
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const FamilyMeasurement& family = methods[i].families[f];
      marks.push_back(
          {i, family.nanoseconds, family.exactness.digits, methods[i].precision, family.exactness.failures > 0});
    }
    if (f == 0) {
      picture.write(
          fmt::format("{}: time against accuracy, family by family; numbers as in work-precision-{}.svg", law, law),
          {20, height - 25}, black);
      double x = 20;
      for (const auto& [text, colour] : key_of_colours) {
        picture.write(text, {x, height - 55}, colour);
        x += 20 + 11 * static_cast<double>(text.size());
      }
    }
    draw(picture, panel, marks, 0.6, 19, [](const Mark& mark, bool is_on_line) { return mark.fails || is_on_line; });
    picture.end();
  }
  return picture;
}

Plot stability_map(const SweepMeasurement& sweep, Law law, double limit_ulps) {
  std::vector<SweepLine> lines;
  for (const SweepLine& line : sweep.lines) {
    if (line.law == law) {
      lines.push_back(line);
    }
  }
  constexpr double font_size = 15;
  const double height = std::max(500.0, name_distance * font_size * static_cast<double>(lines.size()));
  Plot picture(fmt::format("stability-{}-{}", name_of(law), sweep.name), 1200, height + 150, font_size);
  const std::vector<double>& quantity = lines.front().quantity;
  const Panel panel{{quantity.front(), quantity.back(), true, 90, 800},
                    {least_error, most_error, true, 100, height + 100}};
  picture.begin(panel, fmt::format("{}: {}", name_of(law), sweep.summary), sweep.label,
                "worst backward error [ulps of the method's precision]");
  picture.add(power_tics(panel.x, 'x') + '\n' + power_tics(panel.y, 'y'));
  picture.curve({{quantity.front(), limit_ulps}, {quantity.back(), limit_ulps}},
                "using 1:2 with lines lw 2 dt 2 lc rgb '#333333'");
  picture.write(fmt::format("limit: {:g} ulps", limit_ulps),
                {panel.x.last_pixel - 8, panel.y.pixel_of(limit_ulps) + 13}, "#333333", "right");
  std::vector<Label> names;
  std::vector<Label> staying;
  for (const SweepLine& line : lines) {
    const auto points = points_of(line);
    if (points.empty()) {
      continue;
    }
    const Pixel end = panel.place_of(points.back()[0], points.back()[1]);
    if (!line.leaves_limit_at()) {
      picture.curve(points, "using 1:2 with lines lw 1 lc rgb '#aaaaaa'");
      staying.push_back({"", end, std::string(grey)});
      continue;
    }
    const Style style = style_of(line, names.size());
    picture.curve(points, fmt::format("using 1:2 with linespoints lw 2 dt {} pt {} ps 0.6 lc rgb '{}'", style.dash,
                                      style.point, style.colour));
    names.push_back({line.method, end, std::string(style.colour)});
  }
  if (!staying.empty()) {
    names.push_back(staying[staying.size() / 2]);
    names.back().text = staying.size() == 1 ? "1 method that stays below the limit"
                                            : fmt::format("{} methods that stay below the limit", staying.size());
  }
  picture.name_ends(names, panel);
  picture.write(
      "orange: binary32 · blue: binary64 · green: more · at 10²²: no digit is right, or the outcome is not finite",
      {panel.x.first_pixel, 18}, "#555555");
  picture.end();
  return picture;
}

std::vector<DeadlineStep> deadline_steps(std::span<const MethodMeasurement> methods, double digits) {
  std::vector<DeadlineStep> steps;
  for (const MethodMeasurement& method : methods) {
    steps.push_back({method.nanoseconds_over_all_families().median, share_with(method, digits), method.name});
  }
  const std::vector<std::size_t> best = pareto(
      steps.size(), [&](std::size_t i) { return steps[i].nanoseconds; }, [&](std::size_t i) { return steps[i].share; },
      [&](std::size_t i) { return steps[i].share > 0; });
  std::vector<DeadlineStep> result;
  result.reserve(best.size());
  for (const std::size_t i : best) {
    result.push_back(steps[i]);
  }
  return result;
}

Plot deadline(std::span<const MethodMeasurement> methods) {
  const std::string law(name_of(methods.front().law));
  Plot picture("deadline-" + law, 1150, 620, 15);
  double longest = 0;
  double shortest = 1e9;
  for (const MethodMeasurement& method : methods) {
    longest = std::max(longest, method.nanoseconds_over_all_families().median);
    shortest = std::min(shortest, method.nanoseconds_over_all_families().median);
  }
  const Panel panel{{shortest / 1.5, longest * 1.5, true, 75, 690}, {0, 1.04, false, 70, 570}};
  picture.begin(panel, fmt::format("{}: what a deadline allows", law), "time for each contact, at most [ns]",
                "share of the cases of all families");
  picture.add(time_tics(panel.x) + "\nset ytics 0.2");
  constexpr std::array<std::string_view, deadline_digits.size()> colours{sky_blue, orange,     purple,
                                                                         green,    vermillion, blue};
  std::vector<Label> labels;
  std::map<double, std::string> methods_behind;  // by time
  for (std::size_t i = 0; i < deadline_digits.size(); ++i) {
    const std::vector<DeadlineStep> steps = deadline_steps(methods, deadline_digits[i]);
    if (steps.empty()) {
      continue;
    }
    std::vector<std::vector<double>> points{{steps.front().nanoseconds, 0}};
    for (const DeadlineStep& step : steps) {
      points.push_back({step.nanoseconds, step.share});
      methods_behind.emplace(step.nanoseconds, step.method);
    }
    points.push_back({panel.x.high, steps.back().share});
    picture.curve(points, fmt::format("using 1:2 with steps lw 3 dt {} lc rgb '{}'", i % 2 + 1, colours[i]));
    labels.push_back({fmt::format("{} digits", deadline_digits[i]), panel.place_of(panel.x.high, steps.back().share),
                      std::string(colours[i])});
  }
  // The list of the methods that make the steps.
  Pixel at = picture.name_ends(labels, panel);
  at.y = std::min(at.y - 50, panel.y.first_pixel + 21 * static_cast<double>(methods_behind.size() + 1));
  picture.write("the steps are by", at, "#555555");
  for (const auto& [nanoseconds, method] : methods_behind) {
    at.y -= 21;
    picture.write(in_three_digits(nanoseconds) + " ns", {at.x + 65, at.y}, "#555555", "right");
    picture.write(method, {at.x + 75, at.y}, "#555555");
  }
  picture.end();
  return picture;
}

}  // namespace carom::report
