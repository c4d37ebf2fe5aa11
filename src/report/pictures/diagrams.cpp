// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <carom/report/pictures/diagrams.hpp>
#include <carom/report/pictures/plot.hpp>

namespace carom::report {
namespace {

constexpr std::size_t most_methods_drawn = 12;
constexpr std::size_t most_lines_drawn = 8;

/// Errors within this factor look the same.
constexpr double same_error = 3;
constexpr double same_time = 1.1;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// |log(a/b)|. It is infinite if only one of them is 0 or infinite.
double logs_apart(double a, double b) { return a == b ? 0 : std::abs(std::log(a) - std::log(b)); }

struct Representative {
  std::size_t index;
  std::size_t alike;  // others that look the same
};

/// Leaves out the later one of the two nearest until no two of these indices look the same (distance ≤ 1) and at most
/// `most` are left.
template <class Between>
std::vector<Representative> distinct(const std::vector<std::size_t>& indices, std::size_t most,
                                     const Between& between) {
  std::vector<Representative> left;
  for (const std::size_t index : indices) {
    left.push_back({index, 0});
  }
  while (left.size() > 1) {
    double least = infinity;
    std::size_t earlier = left.size() - 2;
    std::size_t later = left.size() - 1;
    for (std::size_t j = 1; j < left.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        const double now = between(left[i].index, left[j].index);
        if (now < least) {
          least = now;
          earlier = i;
          later = j;
        }
      }
    }
    if (least > 1 && left.size() <= most) {
      break;
    }
    left[earlier].alike += least <= 1 ? left[later].alike + 1 : 0;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(later));
  }
  return left;
}

/// A method over all families, with errors in ulps of binary64, so that one axis has all precisions.
struct Mark {
  double nanoseconds;
  double median;
  double worst;
  bool is_batch;
};

double in_ulps_of_binary64(double ulps, Precision precision) {
  return ulps * unit_roundoff(precision) / unit_roundoff(Precision::binary64);
}

Mark mark_of(const MethodMeasurement& method) {
  const Quantiles error = method.over_all_families().backward_error;
  return {method.nanoseconds_over_all_families().median, in_ulps_of_binary64(error.median, method.precision),
          in_ulps_of_binary64(error.worst, method.precision), method.is_batch};
}

double distance(const Mark& a, const Mark& b) {
  if (a.is_batch != b.is_batch) {
    return infinity;
  }
  return std::max({logs_apart(a.nanoseconds, b.nanoseconds) / std::log(same_time),
                   logs_apart(a.median, b.median) / std::log(same_error),
                   logs_apart(a.worst, b.worst) / std::log(same_error)});
}

bool looks_no_larger(double error, double other) { return error <= same_error * other; }

/// An axis of errors over the range of these values, in whole powers of ten. Infinite errors have a place above them.
struct ErrorAxis {
  Axis axis;
  double highest;  // where infinite errors are drawn
  std::string tics;

  [[nodiscard]] double drawn(double error) const { return std::clamp(error, axis.low, highest); }
};

ErrorAxis error_axis(const std::vector<double>& values, double first_pixel, double last_pixel) {
  double low = infinity;
  double high = 0;
  for (const double value : values) {
    if (value > 0 && std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  low = std::pow(10, std::floor(std::log10(low)));
  high = std::pow(10, std::floor(std::log10(high)) + 1);
  const Axis finite{low, high, true, first_pixel, last_pixel};
  if (std::find(values.begin(), values.end(), infinity) == values.end()) {
    return {finite, high, power_tics(finite, 'y')};
  }
  const double whole = high / low;
  const double highest = high * std::pow(whole, 0.1);
  return {{low, high * std::pow(whole, 0.13), true, first_pixel, last_pixel},
          highest,
          power_tics(finite, 'y') + fmt::format("\nset ytics add (\"not finite\" {:g})", highest)};
}

/// A command that draws a dashed line at this error across the diagram.
std::string across(double error, std::string_view colour) {
  return fmt::format("set arrow from graph 0,first {0:g} to graph 1,first {0:g} nohead lw 2 dt 2 lc rgb '{1}'", error,
                     colour);
}

/// Places on the straight line between two places, each a few pixels from the next.
void add_places_between(std::vector<Pixel>& places, Pixel from, Pixel to) {
  const int steps = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / 6) + 1;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    places.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
  }
}

struct Style {
  std::string_view colour;
  int dash;
  int point;
};

/// The colour shows the precision. Methods of one precision differ in dash and mark.
Style style_of(const SweepLine& line, std::size_t index) {
  constexpr std::array points{7, 5, 9, 13, 11, 4, 6, 8};
  return {colour_of(line.precision), static_cast<int>(index % 4) + 1, points[index % points.size()]};
}

double worst_at(const SweepLine& line, std::size_t i) { return line.exactness[i].backward_error.worst; }

/// The worst error along the sweep, where the errors show the method. Zero if they never do.
double worst_of(const SweepLine& line) {
  double worst = 0;
  for (std::size_t i = 0; i < line.quantity.size(); ++i) {
    worst = std::max(worst, line.exactness[i].shows_method() ? worst_at(line, i) : 0);
  }
  return worst;
}

/// At most 1 if the lines look the same. Otherwise 1 and their mean distance, so that a picture with few lines has the
/// most different ones.
double distance(const SweepLine& a, const SweepLine& b) {
  constexpr double far = 20;  // no further, such as the distance of a number and infinity
  double most = 0;
  double sum = 0;
  for (std::size_t i = 0; i < a.quantity.size(); ++i) {
    const bool shown = a.exactness[i].shows_method();
    const double here = shown != b.exactness[i].shows_method() ? far
                        : shown ? std::min(far, logs_apart(worst_at(a, i), worst_at(b, i)) / std::log(same_error))
                                : 0;
    most = std::max(most, here);
    sum += here;
  }
  return a.precision == b.precision && most <= 1 ? most : 1.001 + sum / static_cast<double>(a.quantity.size());
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

std::vector<MethodMeasurement> methods_to_draw(std::span<const MethodMeasurement> methods) {
  std::vector<Mark> marks;
  std::vector<std::size_t> indices;
  for (const MethodMeasurement& method : methods) {
    indices.push_back(marks.size());
    marks.push_back(mark_of(method));
  }
  const auto between = [&](std::size_t i, std::size_t j) { return distance(marks[i], marks[j]); };
  std::vector<std::size_t> quickest_first;
  for (const Representative& one : distinct(indices, methods.size(), between)) {
    quickest_first.push_back(one.index);
  }
  std::stable_sort(quickest_first.begin(), quickest_first.end(),
                   [&](std::size_t i, std::size_t j) { return marks[i].nanoseconds < marks[j].nanoseconds; });
  std::vector<std::size_t> undominated;
  for (const std::size_t i : quickest_first) {
    if (std::none_of(undominated.begin(), undominated.end(), [&](std::size_t quicker) {
          return marks[quicker].is_batch == marks[i].is_batch &&
                 looks_no_larger(marks[quicker].median, marks[i].median) &&
                 looks_no_larger(marks[quicker].worst, marks[i].worst);
        })) {
      undominated.push_back(i);
    }
  }
  std::vector<MethodMeasurement> result;
  for (const Representative& one : distinct(undominated, most_methods_drawn, between)) {
    result.push_back(methods[one.index]);
  }
  return result;
}

Plot work_precision(std::span<const MethodMeasurement> methods, double limit_ulps) {
  const std::string law(name_of(methods.front().law));
  const std::vector<MethodMeasurement> drawn = methods_to_draw(methods);
  constexpr double letter = 14;
  constexpr double width = 1000;
  Plot picture("work-precision-" + law, width, 615, letter);
  std::vector<Precision> precisions;
  std::vector<double> errors;
  double shortest = infinity;
  double longest = 0;
  for (const MethodMeasurement& method : drawn) {
    const Mark mark = mark_of(method);
    errors.insert(errors.end(), {mark.median, mark.worst, in_ulps_of_binary64(limit_ulps, method.precision)});
    shortest = std::min(shortest, mark.nanoseconds);
    longest = std::max(longest, mark.nanoseconds);
    if (std::find(precisions.begin(), precisions.end(), method.precision) == precisions.end()) {
      precisions.push_back(method.precision);
    }
  }
  const ErrorAxis axis = error_axis(errors, 115, 560);
  const Panel panel{{shortest / 1.5, longest * 1.5, true, 85, 790}, axis.axis};
  picture.begin(panel, fmt::format("{}: time against backward error, all families", law), "time for each contact [ns]",
                "backward error [ulps of binary64]");
  picture.add(time_tics(panel.x) + '\n' + axis.tics);
  std::vector<Label> limits;
  for (const Precision precision : precisions) {
    const double limit = in_ulps_of_binary64(limit_ulps, precision);
    picture.add(across(limit, colour_of(precision)));
    limits.push_back({fmt::format("{:g} ulps of {}", limit_ulps, name_of(precision)),
                      panel.place_of(panel.x.high, limit), std::string(colour_of(precision))});
  }
  picture.name_ends(limits, panel);
  std::vector<Label> labels;
  std::vector<Pixel> places;
  for (const Label& limit : limits) {
    add_places_between(places, {panel.x.first_pixel, limit.names.y}, {width, limit.names.y});
  }
  for (const MethodMeasurement& method : drawn) {
    const Mark mark = mark_of(method);
    const double median = axis.drawn(mark.median);
    const double worst = axis.drawn(mark.worst);
    const std::string colour(colour_of(method.precision));
    picture.curve({{mark.nanoseconds, median, mark.nanoseconds, worst}},
                  fmt::format("using 1:2:($3-$1):($4-$2) with vectors nohead lw 2 lc rgb '{}'", colour));
    picture.curve({{mark.nanoseconds, median}}, fmt::format("using 1:2 with points pt 7 ps 0.4 lc rgb '{}'", colour));
    picture.curve({{mark.nanoseconds, worst}},
                  method.fails() ? fmt::format("using 1:2 with points pt 2 ps 1 lw 2.5 lc rgb '{}'", vermillion)
                                 : fmt::format("using 1:2 with points pt 7 ps 0.8 lc rgb '{}'", colour));
    labels.push_back(
        {method.name, panel.place_of(mark.nanoseconds, worst), method.fails() ? std::string(vermillion) : colour});
    add_places_between(places, panel.place_of(mark.nanoseconds, median), labels.back().names);
  }
  Panel within = panel;
  within.x.last_pixel = width - letter;
  place_labels(labels, places, letter, within);
  picture.write(labels, letter);
  const Pixel below{panel.x.first_pixel, 36};
  picture.write("mark: worst case (×: fails) · line: down to the median case · batch: many contacts at once", below,
                "#555555");
  picture.write(fmt::format("{} of {} methods; the others look the same as one of these, or are slower and no better",
                            drawn.size(), methods.size()),
                {below.x, below.y - 22}, "#555555");
  picture.end();
  return picture;
}

std::vector<DrawnLine> lines_to_draw(const SweepMeasurement& sweep, Law law) {
  std::vector<DrawnLine> staying;  // for each precision
  std::vector<std::size_t> leaving;
  for (std::size_t i = 0; i < sweep.lines.size(); ++i) {
    const SweepLine& line = sweep.lines[i];
    if (line.law != law || std::none_of(line.exactness.begin(), line.exactness.end(),
                                        [](const Exactness& at) { return at.shows_method(); })) {
      continue;
    }
    if (line.leaves_limit_at()) {
      leaving.push_back(i);
      continue;
    }
    const auto same = std::find_if(staying.begin(), staying.end(),
                                   [&](const DrawnLine& other) { return other.line->precision == line.precision; });
    if (same == staying.end()) {
      staying.push_back({&line, 0});
    } else {
      *same = {worst_of(line) > worst_of(*same->line) ? &line : same->line, same->alike + 1};
    }
  }
  std::vector<DrawnLine> drawn;
  for (const Representative& one :
       distinct(leaving, most_lines_drawn - staying.size(),
                [&](std::size_t i, std::size_t j) { return distance(sweep.lines[i], sweep.lines[j]); })) {
    drawn.push_back({&sweep.lines[one.index], one.alike});
  }
  drawn.insert(drawn.end(), staying.begin(), staying.end());
  return drawn;
}

namespace {

/// The points of a line; a point without numbers where the errors do not show the method.
std::vector<std::vector<double>> points_of(const SweepLine& line, const ErrorAxis& axis) {
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < line.quantity.size(); ++i) {
    points.push_back(line.exactness[i].shows_method()
                         ? std::vector<double>{line.quantity[i], axis.drawn(worst_at(line, i))}
                         : std::vector<double>{});
  }
  return points;
}

/// Draws a line, and adds its places to `places`. Returns the place of its end.
Pixel draw(Plot& picture, const Panel& panel, const std::vector<std::vector<double>>& points, std::string_view with,
           std::vector<Pixel>& places) {
  picture.curve(points, with);
  Pixel end{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].empty()) {
      const Pixel at = panel.place_of(points[i][0], points[i][1]);
      add_places_between(places, i > 0 && !points[i - 1].empty() ? end : at, at);
      end = at;
    }
  }
  return end;
}

}  // namespace

Plot stability_map(const SweepMeasurement& sweep, Law law, double limit_ulps) {
  const std::vector<DrawnLine> lines = lines_to_draw(sweep, law);
  constexpr double letter = 15;
  Plot picture(fmt::format("stability-{}-{}", name_of(law), sweep.name), 1200, 575, letter);
  std::vector<double> errors{limit_ulps};
  std::size_t shown = 0;
  for (const DrawnLine& drawn : lines) {
    shown += 1 + drawn.alike;
    for (std::size_t i = 0; i < drawn.line->quantity.size(); ++i) {
      errors.push_back(drawn.line->exactness[i].shows_method() ? worst_at(*drawn.line, i) : limit_ulps);
    }
  }
  const std::vector<double>& quantity = sweep.lines.front().quantity;
  const ErrorAxis axis = error_axis(errors, 120, 520);
  const Panel panel{{quantity.front(), quantity.back(), true, 105, 800}, axis.axis};
  picture.begin(panel, fmt::format("{}: {}", name_of(law), sweep.summary), sweep.label,
                "worst backward error [ulps of the method's precision]");
  picture.add(power_tics(panel.x, 'x') + '\n' + axis.tics);
  picture.add(across(limit_ulps, "#333333"));
  std::vector<Label> beside{
      {fmt::format("limit: {:g} ulps", limit_ulps), panel.place_of(quantity.back(), limit_ulps), "#333333"}};
  std::vector<Pixel> places;
  add_places_between(places, panel.place_of(quantity.front(), limit_ulps), beside.front().names);
  std::vector<Label> inside;  // of the lines that end before the sweep does
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const SweepLine& line = *lines[i].line;
    const bool stays = !line.leaves_limit_at();
    const Style style = style_of(line, i);
    const Pixel end = draw(picture, panel, points_of(line, axis),
                           fmt::format("using 1:2 with linespoints lw {} dt {} pt {} ps {} lc rgb '{}'", stays ? 1 : 2,
                                       style.dash, style.point, stays ? 0.3 : 0.6, style.colour),
                           places);
    const Label name{line.method + (lines[i].alike > 0 ? fmt::format(" +{}", lines[i].alike) : ""), end,
                     std::string(style.colour)};
    (end.x < panel.x.last_pixel - 1 ? inside : beside).push_back(name);
  }
  picture.name_ends(beside, panel);
  place_labels(inside, places, letter, panel);
  picture.write(inside, letter);
  const auto of_law = static_cast<std::size_t>(
      std::count_if(sweep.lines.begin(), sweep.lines.end(), [&](const SweepLine& line) { return line.law == law; }));
  picture.write(fmt::format("orange: binary32 · blue: binary64 · green: more{}",
                            shown < of_law ? fmt::format(" · {} more methods are in the table", of_law - shown) : ""),
                {panel.x.first_pixel, 40}, "#555555");
  picture.write(
      "+n: n more of this precision look the same, or stay below the limit with smaller errors · gap: any outcome "
      "passes",
      {panel.x.first_pixel, 16}, "#555555");
  picture.end();
  return picture;
}

std::vector<DeadlineStep> deadline_steps(std::span<const MethodMeasurement> methods, double digits) {
  std::vector<DeadlineStep> steps;
  for (const MethodMeasurement& method : methods) {
    steps.push_back({method.nanoseconds_over_all_families().median, share_with(method, digits), method.name});
  }
  std::sort(steps.begin(), steps.end(), [](const DeadlineStep& a, const DeadlineStep& b) {
    return a.nanoseconds != b.nanoseconds ? a.nanoseconds < b.nanoseconds : a.share > b.share;
  });
  std::vector<DeadlineStep> result;
  for (const DeadlineStep& step : steps) {
    if (step.share > (result.empty() ? 0 : result.back().share)) {
      result.push_back(step);
    }
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
