// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

namespace carom::report {

/// A place in a drawing, with y upwards.
struct Place {
  long double x = 0;
  long double y = 0;
};

/// A small SVG picture that grows with its content. Every coordinate is clamped to ±1000 pixels. The style sheet
/// defines the look of each class.
class Drawing {
 public:
  /// `name` is unique in its page. The title and the description are for readers who do not see the picture.
  Drawing(pugi::xml_node parent, const std::string& name, std::string_view title, std::string_view description);

  void line(const Place& from, const Place& to, const char* look);
  void ellipse(const Place& centre, long double half_width, long double half_height, long double turned,
               const char* look);
  void dot(const Place& centre, const char* look);

  /// Draws an arrow with its name at its end. Draws nothing if the arrow is shorter than a dot.
  void arrow(const Place& from, const Place& along, const char* look, std::string_view name);

  /// A horizontal surface through the origin, hatched above it if `side` is 1, and below it if `side` is −1.
  void wall(int side, long double half_width);

  /// Writes a text next to the anchor, where it covers the least of the finished drawing.
  void label(const Place& anchor, std::string_view text, const char* look = "label");

  /// Writes the labels and sets the size. Call it last.
  void finish();

 private:
  struct Box {
    long double left;
    long double bottom;
    long double right;
    long double top;
  };

  struct Label {
    Place anchor;
    std::string text;
    const char* look;
  };

  void write(const Label& label);
  void occupy(const Place& place);
  void occupy_line(const Place& from, const Place& to);
  [[nodiscard]] long double covered(const Box& box) const;

  pugi::xml_node svg_;
  std::vector<Place> occupied_;
  std::vector<Label> labels_;
  std::vector<Box> written_;  // the boxes of labels
  Box extent_{0, 0, 0, 0};
};

}  // namespace carom::report
