// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <carom/report/chart/diagrams.hpp>
#include <carom/report/drawing/colours.hpp>

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

/// Whether the end of a line is apart from all others.
bool stands_alone(Pixel end, const std::vector<Pixel>& ends) {
  constexpr double near = 18;
  return std::count_if(ends.begin(), ends.end(),
                       [&](const Pixel& other) { return std::hypot(other.x - end.x, other.y - end.y) < near; }) <= 1;
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
  Plot picture(fmt::format("stability-{}-{}", name_of(law), sweep.name), 1400, 760, 17);
  std::vector<SweepLine> lines;
  for (const SweepLine& line : sweep.lines) {
    if (line.law == law) {
      lines.push_back(line);
    }
  }
  const std::vector<double>& quantity = lines.front().quantity;
  const Panel panel{{quantity.front(), quantity.back(), true, 100, 830}, {least_error, most_error, true, 80, 700}};
  picture.begin(panel, fmt::format("{}: {}", name_of(law), sweep.summary), sweep.label,
                "worst backward error [ulps of the method's precision]");
  picture.add(power_tics(panel.x, 'x') + '\n' + power_tics(panel.y, 'y'));
  picture.curve({{quantity.front(), limit_ulps}, {quantity.back(), limit_ulps}},
                "using 1:2 with lines lw 2 dt 2 lc rgb '#333333'");
  picture.write(fmt::format("limit: {:g} ulps", limit_ulps),
                {panel.x.last_pixel - 8, panel.y.pixel_of(limit_ulps) + 13}, "#333333", "right");

  std::vector<Label> labels;
  std::vector<Pixel> ends;
  std::size_t staying = 0;
  std::size_t leaving = 0;
  double y = 695;
  constexpr double key_left = 880;
  const double row = std::min(24.0, (y - 10) / static_cast<double>(lines.size() + 5));
  picture.write("leaves it at", {key_left + 390, y}, "#555555");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::optional<double> at = lines[i].leaves_limit_at();
    if (!at) {
      ++staying;
      picture.curve(points_of(lines[i]), "using 1:2 with lines lw 1 lc rgb '#aaaaaa'");
      continue;
    }
    const Style style = style_of(lines[i], leaving++);
    const auto points = points_of(lines[i]);
    picture.curve(points, fmt::format("using 1:2 with linespoints lw 2 dt {} pt {} ps 0.6 lc rgb '{}'", style.dash,
                                      style.point, style.colour));
    ends.push_back(panel.place_of(points.back()[0], points.back()[1]));
    labels.push_back({std::to_string(i + 1), ends.back(), std::string(style.colour)});
    y -= row;
    picture.swatch({key_left + 20, y}, style.colour, style.dash, style.point);
    picture.write(std::to_string(i + 1), {key_left + 66, y}, style.colour, "right");
    picture.write(lines[i].method, {key_left + 74, y}, style.colour);
    picture.write(fmt::format("{:.0e}", *at), {key_left + 390, y}, style.colour);
  }
  y -= 1.5 * row;
  picture.write(fmt::format("grey: {} methods that stay below it everywhere", staying), {key_left, y}, "#777777");
  y -= row;
  picture.write("orange: binary32 · blue: binary64 · green: more", {key_left, y}, "#777777");
  y -= row;
  picture.write("at 10²²: no digit is right, or the outcome is not finite", {key_left, y}, "#777777");
  // Lines that end close together get no label, because the list at the side names them.
  std::erase_if(labels, [&](const Label& label) { return !stands_alone(label.names, ends); });
  for (Label& label : labels) {
    label.at = {label.names.x + 18, label.names.y};
  }
  picture.write(labels, 15);
  picture.end();
  return picture;
}

}  // namespace carom::report
