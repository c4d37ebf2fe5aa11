// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <carom/report/pictures/drawing.hpp>
#include <carom/report/pictures/markup.hpp>

namespace carom::report {
namespace {

/// Far larger than any picture.
constexpr long double largest = 1000;

/// A coordinate in the drawing, also for numbers that are NaN or too large.
std::string in_pixels(long double number) {
  return fmt::format("{:.1f}", std::isnan(number) ? 0.0L : std::clamp(number, -largest, largest));
}

/// In SVG, y points downwards.
std::string point(const Place& place) { return in_pixels(place.x) + ',' + in_pixels(-place.y); }

}  // namespace

Drawing::Drawing(pugi::xml_node parent, const std::string& name, std::string_view title, std::string_view description)
    : svg_(add(parent, "svg",
               {{"role", "img"}, {"aria-labelledby", name + "-title"}, {"aria-describedby", name + "-description"}})) {
  add(svg_, "title", {{"id", name + "-title"}}, title);
  add(svg_, "desc", {{"id", name + "-description"}}, description);
}

void Drawing::line(const Place& from, const Place& to, const char* look) {
  add(svg_, "path", {{"class", look}, {"d", 'M' + point(from) + 'L' + point(to)}});
  occupy_line(from, to);
}

void Drawing::ellipse(const Place& centre, long double half_width, long double half_height, long double turned,
                      const char* look) {
  const std::string turn = fmt::format("rotate({} {} {})", in_pixels(-turned * 180 / std::numbers::pi_v<long double>),
                                       in_pixels(centre.x), in_pixels(-centre.y));
  add(svg_, "ellipse",
      {{"class", look},
       {"cx", in_pixels(centre.x)},
       {"cy", in_pixels(-centre.y)},
       {"rx", in_pixels(half_width)},
       {"ry", in_pixels(half_height)},
       {"transform", turn}});
  constexpr int steps = 48;
  for (int i = 0; i < steps; ++i) {
    const long double angle = 2 * std::numbers::pi_v<long double> * i / steps;
    const long double x = half_width * std::cos(angle);
    const long double y = half_height * std::sin(angle);
    occupy({centre.x + x * std::cos(turned) - y * std::sin(turned),
            centre.y + x * std::sin(turned) + y * std::cos(turned)});
  }
}

void Drawing::dot(const Place& centre, const char* look) {
  constexpr long double radius = 3;
  add(svg_, "circle",
      {{"class", look}, {"cx", in_pixels(centre.x)}, {"cy", in_pixels(-centre.y)}, {"r", in_pixels(radius)}});
  for (const long double x : {-radius, radius}) {
    for (const long double y : {-radius, radius}) {
      occupy({centre.x + x, centre.y + y});
    }
  }
}

void Drawing::arrow(const Place& from, const Place& along, const char* look, std::string_view name) {
  constexpr long double shortest = 2;
  constexpr long double head_length = 9;
  constexpr long double head_half_width = 3.5;
  const long double length = std::hypot(along.x, along.y);
  if (!(length >= shortest)) {
    return;
  }
  const Place ahead{along.x / length, along.y / length};
  const Place aside{-ahead.y, ahead.x};
  const long double head = std::min(head_length, length * 0.6L);
  const long double half_width = head_half_width * head / head_length;
  const Place tip{from.x + along.x, from.y + along.y};
  const Place neck{tip.x - head * ahead.x, tip.y - head * ahead.y};
  line(from, neck, look);
  const Place left{neck.x + half_width * aside.x, neck.y + half_width * aside.y};
  const Place right{neck.x - half_width * aside.x, neck.y - half_width * aside.y};
  add(svg_, "path",
      {{"class", std::string(look) + " head"}, {"d", 'M' + point(tip) + 'L' + point(left) + 'L' + point(right) + 'Z'}});
  occupy(tip);
  label(tip, name, look);
}

void Drawing::wall(int side, long double half_width) {
  constexpr long double depth = 10;
  line({-half_width, 0}, {half_width, 0}, "surface");
  std::string hatching;
  for (long double x = -half_width; x + depth <= half_width; x += depth) {
    hatching += 'M' + point({x, 0}) + 'L' + point({x + depth, side * depth});
  }
  add(svg_, "path", {{"class", "hatching"}, {"d", hatching}});
  occupy_line({-half_width, side * depth}, {half_width, side * depth});
}

void Drawing::label(const Place& anchor, std::string_view text, const char* look) {
  labels_.push_back({anchor, std::string(text), look});
}

void Drawing::write(const Label& label) {
  const auto& [anchor, text, look] = label;
  constexpr long double height = 13;
  constexpr long double letter_width = 7.5L;
  const auto letters =
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; });
  const long double width = letter_width * static_cast<long double>(letters);
  Box best{};
  long double least = -1;
  for (const long double distance : {7.0L, 14.0L, 24.0L, 38.0L}) {
    for (int eighth = 0; eighth < 8; ++eighth) {
      const long double angle = std::numbers::pi_v<long double> * eighth / 4;
      const Place centre{anchor.x + (distance + width / 2) * std::cos(angle),
                         anchor.y + (distance + height / 2) * std::sin(angle)};
      const Box box{centre.x - width / 2, centre.y - height / 2, centre.x + width / 2, centre.y + height / 2};
      const long double cost = covered(box) + distance / 20;
      if (least < 0 || cost < least) {
        least = cost;
        best = box;
      }
    }
  }
  constexpr long double baseline = 3;
  add(svg_, "text", {{"class", look}, {"x", in_pixels(best.left)}, {"y", in_pixels(-best.bottom - baseline)}}, text);
  written_.push_back(best);
  for (const Place& corner : {Place{best.left, best.bottom}, Place{best.right, best.top}}) {
    occupy(corner);
  }
}

void Drawing::finish() {
  for (const Label& label : labels_) {
    write(label);
  }
  constexpr long double margin = 8;
  constexpr long double smallest = 200;
  const auto widened = [](long double& low, long double& high) {
    const long double missing = std::max(0.0L, smallest - (high - low)) / 2 + margin;
    low -= missing;
    high += missing;
  };
  widened(extent_.left, extent_.right);
  widened(extent_.bottom, extent_.top);
  const std::string width = in_pixels(extent_.right - extent_.left);
  const std::string height = in_pixels(extent_.top - extent_.bottom);
  const std::string box = fmt::format("{} {} {} {}", in_pixels(extent_.left), in_pixels(-extent_.top), width, height);
  svg_.append_attribute("viewBox") = box.c_str();
  svg_.append_attribute("width") = width.c_str();
  svg_.append_attribute("height") = height.c_str();
}

void Drawing::occupy(const Place& place) {
  occupied_.push_back(place);
  extent_ = {std::min(extent_.left, place.x), std::min(extent_.bottom, place.y), std::max(extent_.right, place.x),
             std::max(extent_.top, place.y)};
}

void Drawing::occupy_line(const Place& from, const Place& to) {
  constexpr long double step = 4;
  const long double length = std::min(std::hypot(to.x - from.x, to.y - from.y), largest);
  const int steps = 1 + static_cast<int>(length / step);
  for (int i = 0; i <= steps; ++i) {
    const long double part = static_cast<long double>(i) / steps;
    occupy({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
  }
}

long double Drawing::covered(const Box& box) const {
  constexpr long double air = 2;
  constexpr long double of_label = 100;
  long double sum = 0;
  for (const Place& place : occupied_) {
    const bool inside =
        place.x > box.left - air && place.x < box.right + air && place.y > box.bottom - air && place.y < box.top + air;
    sum += inside ? 1 : 0;
  }
  for (const Box& other : written_) {
    const bool apart =
        other.right < box.left || other.left > box.right || other.top < box.bottom || other.bottom > box.top;
    sum += apart ? 0 : of_label;
  }
  return sum;
}

}  // namespace carom::report
