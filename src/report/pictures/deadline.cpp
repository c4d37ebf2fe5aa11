// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

#include <carom/report/pictures/diagrams.hpp>

namespace carom::report {
namespace {

double share_with(const MethodMeasurement& method, double digits) {
  const Exactness all = method.over_all_families();
  const auto enough = std::count_if(all.digits_of_cases.begin(), all.digits_of_cases.end(),
                                    [&](double of_case) { return of_case >= digits; });
  return static_cast<double>(enough) / static_cast<double>(all.digits_of_cases.size());
}

}  // namespace

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
