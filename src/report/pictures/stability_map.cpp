// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <carom/report/pictures/diagrams.hpp>
#include <carom/report/pictures/plot.hpp>

namespace carom::report {
namespace {

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

}  // namespace

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

}  // namespace carom::report
