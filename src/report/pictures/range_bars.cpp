// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

#include <carom/collision/expects.hpp>
#include <carom/report/pictures/markup.hpp>
#include <carom/report/pictures/plot.hpp>
#include <carom/report/pictures/range_bars.hpp>

namespace carom::report {
namespace {

// Lengths are in pixels.
constexpr double width = 860;
constexpr double name_right = 166;
constexpr double first_pixel = 232;  // of a bar
constexpr double last_pixel = 748;
constexpr double gap = 7;  // between a bar and the value beside it
constexpr double row_height = 30;
constexpr double bar_height = 16;
constexpr double head_height = 66;
constexpr double axis_height = 38;
constexpr double inner_label = 58;  // the room for a value inside a bar

constexpr std::string_view colour_of_holding = blue;
constexpr std::string_view colour_of_losing = orange;
constexpr std::string_view colour_of_failing = "#d9d9d9";
constexpr std::string_view colour_of_grid = "#e4e4e4";

std::string in_pixels(double x) { return fmt::format("{:.1f}", x); }

void write_at(pugi::xml_node svg, double x, double y, std::string_view text, const char* anchor = "start",
              std::string_view colour = black, const char* size = "13") {
  add(svg, "text",
      {{"x", in_pixels(x)}, {"y", in_pixels(y)}, {"text-anchor", anchor}, {"fill", colour}, {"font-size", size}}, text);
}

void rectangle(pugi::xml_node svg, double left, double right, double top, double height, std::string_view colour) {
  if (right > left) {
    add(svg, "rect",
        {{"x", in_pixels(left)},
         {"y", in_pixels(top)},
         {"width", in_pixels(right - left)},
         {"height", in_pixels(height)},
         {"fill", colour}});
  }
}

std::string value_in_words(double x) { return std::isinf(x) ? "∞" : fmt::format("{:.3g}", x); }

/// The left and the right end of an interval in the picture.
Interval pixels_of(const Axis& axis, const Interval& interval) {
  return {axis.pixel_of(interval.low), axis.pixel_of(interval.high)};
}

/// Writes the values to which the stricter limit holds, inside the bar, if they differ from the ends of `holds`.
void write_inner_values(pugi::xml_node row, const Interval& losing, const Interval& keeping, const Interval& values,
                        double baseline) {
  const bool is_wide = keeping.high - keeping.low >= 2 * inner_label;
  const auto write = [&](double x, double value, bool is_left) {
    const double outside = is_left ? x - losing.low : losing.high - x;
    if (outside < 1 || !(is_wide || outside >= inner_label)) {
      return;
    }
    const double inwards = is_left == is_wide ? gap : -gap;
    write_at(row, x + inwards, baseline, value_in_words(value), is_left == is_wide ? "start" : "end",
             is_wide ? "#ffffff" : black, "11");
  };
  write(keeping.low, values.low, true);
  write(keeping.high, values.high, false);
}

void draw_bar(pugi::xml_node svg, const RangePicture& picture, const RangeBar& bar, const Axis& axis, double top) {
  const pugi::xml_node row = add(svg, "g", {{"class", "bar"}});
  const double baseline = top + bar_height - 4;
  write_at(row, name_right, baseline, bar.name, "end");
  const Interval whole = pixels_of(axis, bar.searched);
  const Interval holding = pixels_of(axis, bar.holds);
  rectangle(row, whole.low, whole.high, top, bar_height, colour_of_failing);
  rectangle(row, holding.low, holding.high, top, bar_height,
            picture.stricter.empty() ? colour_of_holding : colour_of_losing);
  if (bar.loses_none) {
    const Interval values{std::max(bar.loses_none->low, bar.holds.low), std::min(bar.loses_none->high, bar.holds.high)};
    const Interval keeping = pixels_of(axis, values);
    rectangle(row, keeping.low, keeping.high, top, bar_height, colour_of_holding);
    write_inner_values(row, holding, keeping, values, baseline);
  }
  write_at(row, first_pixel - gap, baseline, value_in_words(bar.holds.low), "end");
  write_at(row, last_pixel + gap, baseline, value_in_words(bar.holds.high) + (bar.unit.empty() ? "" : ' ' + bar.unit));
  if (bar.beside) {
    const Interval line = pixels_of(axis, *bar.beside);
    rectangle(row, line.low, line.high, top + bar_height + 3, 3, black);
  }
}

void draw_axis(pugi::xml_node svg, const Axis& axis, double top, double bottom) {
  std::vector<std::pair<double, std::string>> tics;
  if (axis.logarithmic) {
    const int first = static_cast<int>(std::lround(std::log10(axis.low)));
    const int last = static_cast<int>(std::lround(std::log10(axis.high)));
    const int step = std::max(1, (last - first) / 6);
    for (int exponent = first; exponent <= last; exponent += step) {
      tics.emplace_back(std::pow(10.0, exponent), exponent == 0 ? "1" : power_of_ten(exponent));
    }
  } else {
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double x = axis.low + share * (axis.high - axis.low);
      tics.emplace_back(x, value_in_words(x));
    }
  }
  for (const auto& [value, text] : tics) {
    const double x = axis.pixel_of(value);
    rectangle(svg, x - 0.5, x + 0.5, top, bottom - top, colour_of_grid);
    write_at(svg, x, bottom + 14, text, "middle", "#555555", "12");
  }
}

void draw_legend(pugi::xml_node svg, const RangePicture& picture) {
  std::vector<std::pair<std::string, std::string_view>> entries;
  if (picture.stricter.empty()) {
    entries.emplace_back(fmt::format("holds to {}", picture.limit), colour_of_holding);
  } else {
    entries.emplace_back(fmt::format("holds to {}", picture.stricter), colour_of_holding);
    entries.emplace_back(fmt::format("loses digits, holds to {}", picture.limit), colour_of_losing);
  }
  entries.emplace_back("fails", colour_of_failing);
  constexpr double baseline = 48;
  constexpr double swatch = 18;
  constexpr double letter = 7.5;
  double x = 16;
  const auto enter = [&](const std::string& text, std::string_view colour, double height) {
    rectangle(svg, x, x + swatch, baseline - 5 - height / 2, height, colour);
    write_at(svg, x + swatch + 6, baseline, text);
    x += swatch + 6 + letter * static_cast<double>(text.size()) + 14;
  };
  for (const auto& [text, colour] : entries) {
    enter(text, colour, 12);
  }
  if (!picture.beside.empty()) {
    enter(picture.beside, black, 3);
  }
}

/// Draws the bars with this scale from `top` downwards, and returns where they end.
double draw_group(pugi::xml_node svg, const RangePicture& picture, bool is_logarithmic, double top) {
  Axis axis{0, 0, is_logarithmic, first_pixel, last_pixel};
  std::vector<const RangeBar*> bars;
  for (const RangeBar& bar : picture.bars) {
    if (bar.is_logarithmic == is_logarithmic) {
      CAROM_EXPECTS(bar.searched.low < bar.searched.high && (!is_logarithmic || bar.searched.low > 0), bar.name);
      axis.low = bars.empty() ? bar.searched.low : std::min(axis.low, bar.searched.low);
      axis.high = bars.empty() ? bar.searched.high : std::max(axis.high, bar.searched.high);
      bars.push_back(&bar);
    }
  }
  if (bars.empty()) {
    return top;
  }
  const double bottom = top + row_height * static_cast<double>(bars.size());
  draw_axis(svg, axis, top - 4, bottom);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    draw_bar(svg, picture, *bars[i], axis, top + row_height * static_cast<double>(i));
  }
  return bottom + axis_height;
}

}  // namespace

std::string range_bars(const RangePicture& picture) {
  pugi::xml_document document;
  const pugi::xml_node svg = add(document, "svg",
                                 {{"xmlns", "http://www.w3.org/2000/svg"},
                                  {"role", "img"},
                                  {"font-family", "Helvetica, Arial, sans-serif"},
                                  {"aria-labelledby", "title"},
                                  {"aria-describedby", "description"}});
  add(svg, "style", {}, dark_style);
  add(svg, "title", {{"id", "title"}}, picture.title);
  add(svg, "desc", {{"id", "description"}}, picture.description);
  add(svg, "rect", {{"width", "100%"}, {"height", "100%"}, {"fill", "#ffffff"}});
  write_at(svg, 16, 24, picture.title, "start", black, "16");
  draw_legend(svg, picture);
  const double end_of_first = draw_group(svg, picture, true, head_height);
  const double height = draw_group(svg, picture, false, end_of_first) - axis_height / 3;
  pugi::xml_node root = svg;
  root.append_attribute("viewBox") = fmt::format("0 0 {} {}", in_pixels(width), in_pixels(height)).c_str();
  root.append_attribute("width") = in_pixels(width).c_str();
  root.append_attribute("height") = in_pixels(height).c_str();
  std::ostringstream text;
  document.save(text, " ", pugi::format_indent, pugi::encoding_utf8);
  return text.str();
}

}  // namespace carom::report
