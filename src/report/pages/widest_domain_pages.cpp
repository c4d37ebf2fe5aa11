// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

#include <carom/collision/expects.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/gate/unjudged.hpp>
#include <carom/report/pages/document.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/pictures/markup.hpp>
#include <carom/report/pictures/plot.hpp>
#include <carom/report/results/values_json.hpp>
#include <carom/report/results/version.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using nlohmann::json;
using properties::Face;

json domain_record(const properties::Domain& domain) { return Json<properties::Domain>::write(domain); }

json witness_record(const properties::Witness& witness) {
  return {{"invariant", witness.invariant->name},
          {"family", witness.family->name},
          {"collision", collision_to_json(witness.shrunk.collision)},
          {"violation", shown(properties::in_words(witness.verdict))}};
}

json ends_record(const properties::Ends& ends, const oracles::Limits& limits) {
  json record{
      {"yardstick", Json<oracles::Limits>::write(limits)}, {"error", shown(ends.error)}, {"faces", json::array()}};
  if (ends.in_core) {
    record["in_core"] = witness_record(*ends.in_core);
  }
  for (const properties::Face& face : ends.faces) {
    record["faces"].push_back({{"quantity", name_of(face.quantity)},
                               {"end", face.is_upper ? "most" : "least"},
                               {"value", face.end},
                               {"beyond", face.beyond ? witness_record(*face.beyond) : json()},
                               {"error", shown(face.error)}});
  }
  return record;
}

std::string witness_text(const properties::Witness& witness) {
  return fmt::format("{}\n  {}\n", properties::in_words(witness.shrunk.collision, "  ").substr(2),
                     shown(properties::in_words(witness.verdict)));
}

std::string end_in_words(double end) { return fmt::format("{:.3g}", end); }

/// The end of the same range with the stricter limits.
std::string stricter_end(const properties::Ends& stricter, const Face& face) {
  const auto found = std::find_if(stricter.faces.begin(), stricter.faces.end(), [&](const Face& other) {
    return other.quantity == face.quantity && other.is_upper == face.is_upper;
  });
  return found == stricter.faces.end() ? "" : end_in_words(found->end);
}

Table table_of(const MeasuredDomain& measured) {
  const properties::WidestDomain& widest = measured.widest;
  const bool has_stricter = widest.stricter && !widest.stricter->faces.empty();
  Table table{"The ends of each range", {{"quantity"}, {"end"}, {"holds to", true}}, {}};
  if (has_stricter) {
    table.columns.push_back({"at " + limit_in_words(*measured.options.stricter), true});
  }
  table.columns.push_back({"in the domain", true});
  table.columns.push_back({"violated beyond"});
  for (const Face& face : widest.ends.faces) {
    const properties::Range& range = widest.domain.ranges[face.quantity];
    std::vector<Cell> row{
        {std::string(name_of(face.quantity))}, {face.is_upper ? "most" : "least"}, {end_in_words(face.end)}};
    if (has_stricter) {
      row.push_back({stricter_end(*widest.stricter, face)});
    }
    row.push_back({end_in_words(face.is_upper ? range.most : range.least)});
    row.push_back({face.beyond          ? std::string(face.beyond->invariant->name)
                   : face.error.empty() ? std::string("the search ends here")
                                        : "error: " + shown(face.error)});
    table.rows.push_back({std::move(row)});
  }
  return table;
}

/// Empty if the stricter limits hold in the core, or if there is none.
std::string stricter_in_core(const MeasuredDomain& measured) {
  const std::optional<properties::Ends>& stricter = measured.widest.stricter;
  if (!stricter || !stricter->faces.empty()) {
    return "";
  }
  const std::string limit = limit_in_words(*measured.options.stricter);
  return stricter->in_core
             ? fmt::format("\nAt {}, the subject violates {} where the search starts.\n\n  {}", limit,
                           stricter->in_core->invariant->name, witness_text(*stricter->in_core))
             : fmt::format("\nAt {}, the subject could not be judged: {}\n", limit, shown(stricter->error));
}

/// From `low` to `high`.
struct Interval {
  double low;
  double high;
};

/// The values of one quantity, and those with which a solver holds.
struct RangeBar {
  std::string name;
  std::string unit;  // empty for a number without a unit
  bool is_logarithmic;
  Interval searched;                        // the whole bar
  Interval holds;                           // with the limit of the picture
  std::optional<Interval> loses_none = {};  // holds with the stricter limit
  std::optional<Interval> beside = {};      // a range to compare with, drawn as a thin line
};

struct RangePicture {
  std::string title;
  std::string description;  // for readers who do not see the picture
  std::string limit;        // such as "3 digits"
  std::string stricter;     // a limit such as "32 ulps"; empty for none
  std::string beside;       // the name of the thin lines; empty for none
  std::vector<RangeBar> bars;
};

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

/// An SVG with one bar for each quantity. The parts of a bar say where the solver holds, loses digits (if the picture
/// has a stricter limit), and fails. All logarithmic bars share an axis. All linear bars share another. Preconditions:
/// every bar has `low` < `high` in `searched`, and a logarithmic bar has `low` > 0 there.
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

Interval interval_of(const properties::Range& range) { return {range.least, range.most}; }

}  // namespace

json widest_domain_record(const MeasuredDomain& measured) {
  const auto& [subject, deviates, options, widest, effects] = measured;
  json record = ends_record(widest.ends, options.limits);
  record.update({{"carom", version},
                 {"subject", subject},
                 {"seed", options.seed},
                 {"core", domain_record(options.core)},
                 {"domain", domain_record(widest.domain)},
                 {"share", widest.share},
                 {"cases", widest.cases},
                 {"not_judged", Json<properties::UnjudgedCounts>::write(widest.unjudged)}});
  if (!deviates.empty()) {
    record["deviates"] = deviates;
  }
  if (widest.stricter) {
    record["stricter"] = ends_record(*widest.stricter, *options.stricter);
  }
  return record;
}

std::string widest_domain_text(const MeasuredDomain& measured) {
  const auto& [subject, deviates, options, widest, declared] = measured;
  const std::string effects = properties::to_text(declared);
  std::string text =
      fmt::format("Carom {}: the domain of {}, seed {}, limit {}\nThe search starts from {}.\n{}{}\n", version,
                  shown(subject), options.seed, limit_in_words(options.limits), to_text(options.core),
                  deviates.empty() ? "" : fmt::format("Not judged: {}.\n", fmt::join(deviates, ", ")),
                  effects.empty() ? "" : fmt::format("Judged without its declared effects: {}.\n", effects));
  if (!widest.ends.error.empty()) {
    return text + fmt::format("The subject could not be judged in these ranges: {}\n", shown(widest.ends.error));
  }
  if (widest.ends.in_core) {
    return text + fmt::format(
                      "The subject violates {} in these ranges, so it has no domain around them. Choose other "
                      "ranges by --core.\n\n  {}",
                      widest.ends.in_core->invariant->name, witness_text(*widest.ends.in_core));
  }
  text += in_text({table_of(measured)});
  text += fmt::format(
      "\n*holds to*: only this quantity leaves the core. *in the domain*: all quantities leave it together{}.\n\n"
      "{}\n\nNo violation in {} fresh cases of this domain. A defect that shows in fewer than 3 of "
      "so many cases can be missed.\n",
      widest.share < 1 ? fmt::format(", {:.0f} % of the way", 100 * widest.share) : "", to_text(widest.domain),
      widest.cases);
  for (const properties::Unjudged reason : properties::all_reasons_unjudged) {
    if (widest.unjudged[reason] > 0) {
      text += fmt::format("{} of the cases were not judged: {}.\n", widest.unjudged[reason], in_words(reason));
    }
  }
  text += stricter_in_core(measured);
  for (const Face& face : widest.ends.faces) {
    if (face.beyond) {
      text +=
          fmt::format("\n{} {} {:.3g}: violates {}\n  {}", name_of(face.quantity), face.is_upper ? "above" : "below",
                      face.end, face.beyond->invariant->name, witness_text(*face.beyond));
    }
  }
  return text;
}

std::string widest_domain_svg(const MeasuredDomain& measured, const properties::Domain& beside,
                              const std::string& name_of_beside) {
  const auto& [subject, deviates, options, widest, effects] = measured;
  CAROM_EXPECTS(measured.is_known(), subject);
  RangePicture picture{
      fmt::format("The domain of {}", shown(subject)),
      fmt::format("For each quantity, a bar shows where {} holds if only this quantity leaves the core {}.",
                  shown(subject), to_text(options.core)),
      limit_in_words(options.limits),
      widest.stricter ? limit_in_words(*options.stricter) : "",
      beside.is_everything() ? "" : shown(name_of_beside),
      {}};
  for (const properties::LimitedQuantity quantity : properties::all_limited_quantities) {
    RangeBar bar{std::string(name_of(quantity)), std::string(unit_of(quantity)), !is_linear(quantity),
                 interval_of(properties::searched_range(quantity)),
                 interval_of(range_of(widest.ends, options.core, quantity))};
    if (widest.stricter && !widest.stricter->faces.empty()) {
      bar.loses_none = interval_of(range_of(*widest.stricter, options.core, quantity));
    }
    if (beside.ranges[quantity] != properties::whole_range(quantity)) {
      bar.beside = interval_of(beside.ranges[quantity]);
    }
    picture.bars.push_back(std::move(bar));
  }
  return range_bars(picture);
}

}  // namespace carom::report
