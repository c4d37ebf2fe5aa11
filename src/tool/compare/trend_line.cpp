// SPDX-License-Identifier: BSL-1.0
#include "compare/trend_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "report/markup.hpp"

namespace carom::tool::compare {
namespace {

constexpr double width = 240;
constexpr double height = 48;
constexpr double margin = 5;

bool is_drawn(const std::optional<double>& value) { return value && !std::isnan(*value); }

double logarithm(double value) { return std::log1p(std::max(value, 0.0)); }

}  // namespace

void add_trend_line(pugi::xml_node parent, const std::string& label, const std::vector<std::optional<double>>& values) {
  double top = 0;
  for (const std::optional<double>& value : values) {
    top = is_drawn(value) && std::isfinite(*value) ? std::max(top, logarithm(*value)) : top;
  }
  const auto x = [&](std::size_t i) {
    return values.size() < 2
               ? width / 2
               : margin + (width - 2 * margin) * static_cast<double>(i) / static_cast<double>(values.size() - 1);
  };
  const auto y = [&](double value) {
    const double share = !std::isfinite(value) ? 1 : (top > 0 ? logarithm(value) / top : 0);
    return height - margin - (height - 2 * margin) * share;
  };
  const pugi::xml_node svg = add(parent, "svg",
                                 {{"viewBox", fmt::format("0 0 {} {}", width, height)},
                                  {"width", fmt::format("{}", width)},
                                  {"height", fmt::format("{}", height)},
                                  {"role", "img"},
                                  {"aria-label", label}});
  std::string path;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_drawn(values[i])) {
      const bool goes_on = i > 0 && is_drawn(values[i - 1]);
      path += fmt::format("{}{:.1f} {:.1f}", goes_on ? 'L' : 'M', x(i), y(*values[i]));
    }
  }
  add(svg, "path", {{"d", path}});
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_drawn(values[i])) {
      add(svg, "circle",
          {{"class", "point"},
           {"cx", fmt::format("{:.1f}", x(i))},
           {"cy", fmt::format("{:.1f}", y(*values[i]))},
           {"r", "2.5"}});
    }
  }
}

}  // namespace carom::tool::compare
