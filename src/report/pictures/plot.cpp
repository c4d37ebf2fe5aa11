// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <carom/report/pictures/plot.hpp>

namespace carom::report {
namespace {

struct Rectangle {
  double left;
  double right;
  double bottom;
  double top;
};

Rectangle box_around(Pixel middle, double width, double height) {
  return {middle.x - width / 2, middle.x + width / 2, middle.y - height / 2, middle.y + height / 2};
}

double overlap(const Rectangle& a, const Rectangle& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.top, b.top) - std::max(a.bottom, b.bottom);
  return width > 0 && height > 0 ? width * height : 0;
}

/// The height of a label, relative to the font size.
constexpr double label_height = 1.2;

/// The middles of a box of this size at growing distances around a place, the upper right first.
std::vector<Pixel> middles_around(Pixel place, double width, double height, double letter) {
  constexpr int directions = 16;
  std::vector<Pixel> middles;
  for (double distance = 0.5; distance < 24; distance *= 1.2) {
    for (int k = 0; k < directions; ++k) {
      const double angle = 2 * M_PI * (k + 2) / directions;
      middles.push_back({place.x + (width / 2 + letter * distance) * std::cos(angle),
                         place.y + (height / 2 + letter * distance) * std::sin(angle)});
    }
  }
  return middles;
}

/// The relative luminance of an sRGB channel from 0 to 255.
double luminance(double channel) {
  const double part = channel / 255;
  return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

}  // namespace

std::string readable(std::string_view colour) {
  constexpr double contrast = 4.5;
  std::array<double, 3> rgb{};
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    rgb[i] = std::stoi(std::string(colour.substr(1 + 2 * i, 2)), nullptr, 16);
  }
  while (1.05 / (0.2126 * luminance(rgb[0]) + 0.7152 * luminance(rgb[1]) + 0.0722 * luminance(rgb[2]) + 0.05) <
         contrast) {
    for (double& channel : rgb) {
      channel = std::floor(channel * 0.98);
    }
  }
  return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(rgb[0]), static_cast<int>(rgb[1]),
                     static_cast<int>(rgb[2]));
}

void spread(std::vector<double>& heights, double gap, double least) {
  for (std::size_t i = 1; i < heights.size(); ++i) {
    heights[i] = std::min(heights[i], heights[i - 1] - gap);
  }
  double below = least - gap;
  for (std::size_t i = heights.size(); i-- > 0;) {
    heights[i] = std::max(heights[i], below + gap);
    below = heights[i];
  }
}

double Axis::pixel_of(double value) const {
  const double clamped = std::clamp(value, std::min(low, high), std::max(low, high));
  const double share = logarithmic ? std::log(clamped / low) / std::log(high / low) : (clamped - low) / (high - low);
  return first_pixel + share * (last_pixel - first_pixel);
}

void place_labels(std::vector<Label>& labels, const std::vector<Pixel>& to_keep_free, double letter,
                  const Panel& within) {
  std::vector<Rectangle> taken;
  taken.reserve(to_keep_free.size() + labels.size());
  for (const Pixel& place : to_keep_free) {
    taken.push_back(box_around(place, letter * 0.6, letter * 0.6));
  }
  for (Label& label : labels) {
    // Half a letter wider, so that two labels are not read as one.
    const double width = letter * (letter_width * static_cast<double>(label.text.size()) + 0.5);
    const double height = letter * label_height;
    double least = std::numeric_limits<double>::infinity();
    for (const Pixel& at : middles_around(label.names, width, height, letter)) {
      const Rectangle box = box_around(at, width, height);
      double cost = std::hypot(std::max(0.0, std::abs(at.x - label.names.x) - width / 2),
                               std::max(0.0, std::abs(at.y - label.names.y) - height / 2));
      for (const Rectangle& other : taken) {
        cost += 10 * overlap(box, other);
      }
      const bool is_inside = box.left >= within.x.first_pixel && box.right <= within.x.last_pixel &&
                             box.bottom >= within.y.first_pixel && box.top <= within.y.last_pixel;
      cost += is_inside ? 0 : 1e6;
      if (cost < least) {
        least = cost;
        label.at = at;
      }
    }
    taken.push_back(box_around(label.at, width, height));
  }
}

Plot::Plot(std::string name, double width, double height, double font_size)
    : name_(std::move(name)), width_(width), height_(height), font_size_(font_size) {
  text_ = fmt::format(
      "set terminal svg size {:.0f},{:.0f} dynamic noenhanced font 'Helvetica,{:.0f}' background rgb 'white'\n"
      "set output '{}.svg'\n"
      "set encoding utf8\nset multiplot\nset key off\nset tics nomirror\nset border 3 lc rgb '#555555'\n"
      "set grid lc rgb '#e4e4e4' lw 1\nset style textbox opaque fillcolor rgb 'white' noborder margins 0.2,0.2\n",
      width, height, font_size, name_);
}

void Plot::begin(const Panel& panel, std::string_view title, std::string_view x_name, std::string_view y_name) {
  text_ += fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n"
      "set tmargin at screen {:.6f}\n",
      panel.x.first_pixel / width_, panel.x.last_pixel / width_, panel.y.first_pixel / height_,
      panel.y.last_pixel / height_);
  for (const auto& [axis, letter] : {std::pair{panel.x, 'x'}, std::pair{panel.y, 'y'}}) {
    text_ += fmt::format("{} logscale {}\nset {}range [{:g}:{:g}]\n", axis.logarithmic ? "set" : "unset", letter,
                         letter, axis.low, axis.high);
    text_ += fmt::format("set format {} \"{}\"\n", letter, axis.logarithmic ? "%.0e" : "%g");
  }
  text_ += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\nunset label\nunset arrow\n", gnuplot_text(title),
                       gnuplot_text(x_name), gnuplot_text(y_name));
}

void Plot::add(std::string_view command) {
  text_ += command;
  text_ += '\n';
}

void Plot::write(std::string_view text, Pixel at, std::string_view colour, std::string_view align, double size) {
  text_ += fmt::format("set label {} at screen {:.6f},{:.6f} {} front tc rgb '{}' font ',{:.1f}'\n", gnuplot_text(text),
                       at.x / width_, at.y / height_, align, readable(colour), size * font_size_);
}

void Plot::write(const std::vector<Label>& labels, double letter) {
  for (const Label& label : labels) {
    const double half = letter * letter_width * static_cast<double>(label.text.size()) / 2;
    const Pixel nearest{std::clamp(label.names.x, label.at.x - half, label.at.x + half), label.at.y};
    if (std::hypot(nearest.x - label.names.x, nearest.y - label.names.y) > 1.6 * letter) {
      text_ += fmt::format("set arrow from screen {:.6f},{:.6f} to screen {:.6f},{:.6f} nohead lw 0.7 lc rgb '{}'\n",
                           label.names.x / width_, label.names.y / height_, nearest.x / width_, nearest.y / height_,
                           label.colour);
    }
    text_ += fmt::format("set label {} at screen {:.6f},{:.6f} center front boxed tc rgb '{}' font ',{:.1f}'\n",
                         gnuplot_text(label.text), label.at.x / width_, label.at.y / height_, readable(label.colour),
                         letter);
  }
}

Pixel Plot::name_ends(std::vector<Label> names, const Panel& panel) {
  const auto higher = [](const Label& a, const Label& b) { return a.names.y > b.names.y; };
  std::stable_sort(names.begin(), names.end(), higher);
  std::vector<double> heights;
  for (const Label& name : names) {
    heights.push_back(name.names.y);
  }
  spread(heights, name_distance * font_size_, panel.y.first_pixel);
  Pixel at{panel.x.last_pixel + 2 * font_size_, panel.y.last_pixel};
  for (std::size_t i = 0; i < names.size(); ++i) {
    at.y = heights[i];
    text_ += fmt::format("set arrow from screen {:.6f},{:.6f} to screen {:.6f},{:.6f} nohead lw 0.7 dt 3 lc rgb '{}'\n",
                         names[i].names.x / width_, names[i].names.y / height_, (at.x - 4) / width_, at.y / height_,
                         names[i].colour);
    write(names[i].text, at, names[i].colour);
  }
  return at;
}

void Plot::curve(const std::vector<std::vector<double>>& points, std::string_view with) {
  if (points.empty()) {
    return;
  }
  const std::string block = fmt::format("$data{}", blocks_written_++);
  blocks_ += block + " << END\n";
  for (const std::vector<double>& point : points) {
    for (const double number : point) {
      blocks_ += fmt::format("{:.8g} ", number);
    }
    blocks_ += '\n';
  }
  blocks_ += "END\n";
  plot_ += fmt::format("{}{} {}", plot_.empty() ? "plot " : ", \\\n  ", block, with);
}

void Plot::end() {
  text_ += blocks_ + plot_ + '\n';
  blocks_.clear();
  plot_.clear();
}

std::string Plot::script() const { return text_ + "unset multiplot\n"; }

std::string time_tics(const Axis& axis) {
  constexpr double room = 60;  // for a number [pixels]
  std::string tics;
  double last = -room;
  for (const double decade : {1e-3, 1e-2, 1e-1, 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6}) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double value = decade * step;
      if (value >= axis.low && value <= axis.high && axis.pixel_of(value) - last >= room) {
        tics += fmt::format("{}\"{:g}\" {:g}", tics.empty() ? "" : ", ", value, value);
        last = axis.pixel_of(value);
      }
    }
  }
  return "set xtics (" + tics + ")";
}

std::string power_of_ten(int exponent) {
  constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += raised[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

std::string power_tics(const Axis& axis, char letter) {
  const int first = static_cast<int>(std::lround(std::log10(std::min(axis.low, axis.high))));
  const int last = static_cast<int>(std::lround(std::log10(std::max(axis.low, axis.high))));
  const int step = std::max(1, (last - first + 4) / 8);
  std::string tics;
  for (int exponent = first; exponent <= last; exponent += step) {
    tics += fmt::format("{}\"{}\" 1e{}", tics.empty() ? "" : ", ", power_of_ten(exponent), exponent);
  }
  return fmt::format("set {}tics ({})", letter, tics);
}

std::string gnuplot_text(std::string_view text) {
  std::string result = "\"";
  for (const char letter : text) {
    const bool is_control = static_cast<unsigned char>(letter) < ' ' || letter == '\x7f';
    if (letter == '"' || letter == '\\') {
      result += '\\';
    }
    result += is_control ? ' ' : letter == '`' ? '\'' : letter;
  }
  return result + '"';
}

}  // namespace carom::report
