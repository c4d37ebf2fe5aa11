// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
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

}  // namespace carom::report
