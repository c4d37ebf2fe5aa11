// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

namespace carom::report {

/// A place in a drawing, y upwards.
struct Place {
  long double x = 0;
  long double y = 0;
};

/// A small picture in SVG that grows with what is drawn in it. No attribute is ever anything but a moderate number.
/// What stands in it gets its looks from the style sheet, by class.
class Drawing {
 public:
  /// `name` is unique in its page; title and description are for those who do not see the picture.
  Drawing(pugi::xml_node parent, const std::string& name, std::string_view title, std::string_view description);

  void line(const Place& from, const Place& to, const char* look);
  void ellipse(const Place& centre, long double half_width, long double half_height, long double turned,
               const char* look);
  void dot(const Place& centre, const char* look);

  /// Nothing where it would be shorter than a dot.
  void arrow(const Place& from, const Place& along, const char* look);

  /// A surface through the origin, across the drawing, hatched on the side of a body: 1 above it, −1 below.
  void wall(int side, long double half_width);

  /// Beside the anchor, where it covers least of what is drawn. To be called after all else is.
  void label(const Place& anchor, std::string_view text);

  /// Sets the size. To be called last.
  void finish();

 private:
  struct Box {
    long double left;
    long double bottom;
    long double right;
    long double top;
  };

  void occupy(const Place& place);
  void occupy_line(const Place& from, const Place& to);
  [[nodiscard]] long double covered(const Box& box) const;

  pugi::xml_node svg_;
  std::vector<Place> occupied_;
  std::vector<Box> labels_;
  Box extent_{0, 0, 0, 0};
};

}  // namespace carom::report
