// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "chart/diagrams.hpp"

namespace carom::tool::chart {
namespace {

constexpr double least_error = 0.01;
constexpr double most_error = 1e22;  // also what is not finite

constexpr std::size_t most_labels = 8;

struct Style {
  std::string_view colour;
  int dash;
  int point;
};

/// The first seven differ in colour and mark, further ones in the dash as well.
Style style_of(std::size_t index) {
  constexpr std::array colours{vermillion, blue, green, purple, orange, sky_blue, black};
  constexpr std::array points{7, 5, 9, 13, 11, 4, 6};
  return {colours[index % colours.size()], static_cast<int>(index / colours.size() % 4) + 1,
          points[index % points.size()]};
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

Picture stability_map(const SweepMeasurement& sweep, Model model, double limit_ulps) {
  Picture picture(fmt::format("stability-{}-{}", name_of(model), sweep.name), 1400, 760, 17);
  std::vector<SweepLine> lines;
  for (const SweepLine& line : sweep.lines) {
    if (line.model == model) {
      lines.push_back(line);
    }
  }
  const std::vector<double>& quantity = lines.front().quantity;
  const Panel panel{{quantity.front(), quantity.back(), true, 100, 830}, {least_error, most_error, true, 80, 700}};
  picture.begin(panel, fmt::format("{}: {}", name_of(model), sweep.summary), sweep.label,
                "worst backward error [ulps of the method's precision]");
  picture.add(power_tics(panel.x, 'x') + '\n' + power_tics(panel.y, 'y'));
  picture.curve({{quantity.front(), limit_ulps}, {quantity.back(), limit_ulps}},
                "using 1:2 with lines lw 2 dt 2 lc rgb '#333333'");
  picture.write(fmt::format("limit: {:g} ulps", limit_ulps),
                {panel.x.last_pixel - 8, panel.y.pixel_of(limit_ulps) + 13}, "#333333", "right");

  std::vector<Label> labels;
  std::vector<Place> to_keep_free;
  std::size_t staying = 0;
  std::size_t leaving = 0;
  double y = 690;
  constexpr double key_left = 860;
  constexpr double row = 24;
  picture.write("leaves the limit at", {key_left + 400, y}, "#555555");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::optional<double> at = lines[i].leaves_limit_at();
    if (!at) {
      ++staying;
      picture.curve(points_of(lines[i]), "using 1:2 with lines lw 1 lc rgb '#aaaaaa'");
      continue;
    }
    const Style style = style_of(leaving++);
    const auto points = points_of(lines[i]);
    picture.curve(points, fmt::format("using 1:2 with linespoints lw 2 dt {} pt {} ps 0.6 lc rgb '{}'", style.dash,
                                      style.point, style.colour));
    for (const auto& point : points) {
      to_keep_free.push_back(panel.place_of(point[0], point[1]));
      if (point[0] == *at) {
        labels.push_back({std::to_string(i + 1), to_keep_free.back(), std::string(style.colour)});
      }
    }
    y -= row;
    picture.swatch({key_left + 20, y}, style.colour, style.dash, style.point);
    picture.write(std::to_string(i + 1), {key_left + 66, y}, style.colour, "right");
    picture.write(lines[i].method, {key_left + 74, y}, style.colour);
    picture.write(fmt::format("{:.0e}", *at), {key_left + 400, y}, style.colour);
  }
  y -= 1.5 * row;
  picture.write(fmt::format("grey: {} methods that stay below it everywhere", staying), {key_left, y}, "#777777");
  if (labels.size() > most_labels) {
    labels.clear();  // many leave together: the list tells them apart
  }
  place_labels(labels, to_keep_free, 15, panel);
  picture.write(labels, 15);
  picture.end();
  return picture;
}

}  // namespace carom::tool::chart
