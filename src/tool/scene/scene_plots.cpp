// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "scene/scene_records.hpp"

namespace carom::tool {
namespace {

using report::Label;
using report::Plot;
using Quantity = std::function<double(const Sample&)>;

constexpr std::array<std::string_view, 6> colours{report::blue,   report::vermillion, report::green,
                                                  report::purple, report::orange,     report::sky_blue};

struct Line {
  std::string name;
  const std::vector<Sample>* samples;
  Quantity quantity;
};

Plot lines_over_time(const std::string& name, const std::string& title, const std::string& y_name,
                     const std::vector<Line>& lines) {
  double low = 0;
  double high = 0;
  double last = 0;
  for (const Line& line : lines) {
    for (const Sample& sample : *line.samples) {
      low = std::min(low, line.quantity(sample));
      high = std::max(high, line.quantity(sample));
      last = std::max(last, sample.time);
    }
  }
  const double margin = high > low ? 0.05 * (high - low) : 1;
  Plot picture(name, 1000, 520, 16);
  const report::Panel panel{{0, last > 0 ? last : 1, false, 110, 800},
                            {low - (low < 0 ? margin : 0), high + margin, false, 75, 470}};
  picture.begin(panel, title, "time [s]", y_name);
  std::vector<Label> names;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string_view colour = colours[k % colours.size()];
    std::vector<std::vector<double>> points;
    for (const Sample& sample : *lines[k].samples) {
      points.push_back({sample.time, lines[k].quantity(sample)});
    }
    picture.curve(points, fmt::format("using 1:2 with lines lw 2 dt {} lc rgb '{}'", k % 3 + 1, colour));
    if (!points.empty()) {
      names.push_back({lines[k].name, panel.place_of(points.back()[0], points.back()[1]), std::string(colour)});
    }
  }
  picture.name_ends(names, panel);
  picture.end();
  return picture;
}

std::vector<Line> one_line_a_law(std::span<const SampledLaw> laws, const Quantity& quantity) {
  std::vector<Line> lines;
  for (const SampledLaw& law : laws) {
    lines.push_back({law.law, &law.samples, quantity});
  }
  return lines;
}

}  // namespace

Plot energy_plot(std::span<const SampledLaw> laws) {
  if (laws.size() == 1) {
    const std::vector<Sample>& samples = laws.front().samples;
    const double first = samples.empty() ? 0 : samples.front().total();
    return lines_over_time("energy", "Energy and losses", "energy [J]",
                           {{"translation", &samples, [](const Sample& s) { return s.translation; }},
                            {"rotation", &samples, [](const Sample& s) { return s.rotation; }},
                            {"potential", &samples, [](const Sample& s) { return s.potential; }},
                            {"lost", &samples, [first](const Sample& s) { return first - s.total(); }}});
  }
  return lines_over_time("energy", "Mechanical energy under each law", "energy [J]",
                         one_line_a_law(laws, [](const Sample& s) { return s.total(); }));
}

Plot momentum_plot(std::span<const SampledLaw> laws) {
  if (laws.size() == 1) {
    const std::vector<Sample>& samples = laws.front().samples;
    return lines_over_time("momentum", "Momentum", "momentum [N s]",
                           {{"x", &samples, [](const Sample& s) { return s.momentum[0]; }},
                            {"y", &samples, [](const Sample& s) { return s.momentum[1]; }},
                            {"z", &samples, [](const Sample& s) { return s.momentum[2]; }}});
  }
  return lines_over_time("momentum", "Size of the momentum under each law", "momentum [N s]",
                         one_line_a_law(laws, [](const Sample& s) { return s.momentum.norm(); }));
}

Plot spin_plot(std::span<const SampledLaw> laws) {
  return lines_over_time("spin", "Mean of ‖w‖ over the spheres", "‖w‖ [rad/s]",
                         one_line_a_law(laws, [](const Sample& s) { return s.mean_spin; }));
}

}  // namespace carom::tool
