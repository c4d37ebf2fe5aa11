// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/precision.hpp>

namespace carom::report {

/// A place in a picture [pixels from its lower left corner].
struct Pixel {
  double x;
  double y;
};

/// The values of one axis, and the pixels of its ends.
struct Axis {
  double low;
  double high;
  bool logarithmic;
  double first_pixel;  // of `low`
  double last_pixel;   // of `high`

  /// The pixel of a value. A value outside of the axis is moved to its end.
  [[nodiscard]] double pixel_of(double value) const;
};

/// One diagram in a picture.
struct Panel {
  Axis x;
  Axis y;

  [[nodiscard]] Pixel place_of(double x_value, double y_value) const {
    return {x.pixel_of(x_value), y.pixel_of(y_value)};
  }
};

/// A short text next to the place that it names.
struct Label {
  std::string text;
  Pixel names;
  std::string colour;
  Pixel at{0, 0};  // its middle, once it is placed
};

/// The width of a letter of common sans-serif fonts, relative to the font size.
inline constexpr double letter_width = 0.52;

/// Moves each label close to the place that it names, within the panel. If there is room, no label covers another label
/// or a place in `to_keep_free`. `letter` is the size of a letter in pixels.
void place_labels(std::vector<Label>& labels, const std::vector<Pixel>& to_keep_free, double letter,
                  const Panel& within);

/// A picture as a gnuplot script: an SVG of a fixed size in pixels.
class Plot {
 public:
  Plot(std::string name, double width, double height, double font_size);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] double font_size() const { return font_size_; }

  /// Starts a diagram with its axes, their names and its title.
  void begin(const Panel& panel, std::string_view title, std::string_view x_name, std::string_view y_name);
  /// Adds a command to the open diagram, before its curves.
  void add(std::string_view command);
  /// Writes a text with its left end, middle or right end at a place, in a readable shade of the colour. Call it in any
  /// diagram, before its curves.
  void write(std::string_view text, Pixel at, std::string_view colour = "#000000", std::string_view align = "left",
             double size = 1);
  /// Writes placed labels on white. A line joins a label to its place if the two are apart.
  void write(const std::vector<Label>& labels, double letter);
  /// Writes the names of lines in a column to the right of a diagram, each beside the end of its line. A thin line
  /// joins a name to its end. Returns the left end of the lowest name. Call it before end().
  Pixel name_ends(std::vector<Label> names, const Panel& panel);
  /// Adds a curve or marks through points, in the gnuplot style `with`. Each point has two numbers (x and y) or four
  /// (the two ends of an arrow). A point without numbers breaks the curve. Without points, it adds nothing.
  void curve(const std::vector<std::vector<double>>& points, std::string_view with);
  /// Draws the open diagram.
  void end();

  /// The whole script, which writes NAME.svg into the working directory.
  [[nodiscard]] std::string script() const;

 private:
  std::string name_;
  double width_;
  double height_;
  double font_size_;
  std::string text_;
  std::string blocks_;  // data of the open diagram
  std::string plot_;    // its plot command so far
  int blocks_written_ = 0;
};

/// Colours that people with any colour vision can distinguish: M. Okabe, K. Ito, "Color Universal Design" (2008).
inline constexpr std::string_view orange = "#e69f00";
inline constexpr std::string_view sky_blue = "#56b4e9";
inline constexpr std::string_view green = "#009e73";
inline constexpr std::string_view blue = "#0072b2";
inline constexpr std::string_view vermillion = "#d55e00";
inline constexpr std::string_view purple = "#cc79a7";
inline constexpr std::string_view black = "#000000";
inline constexpr std::string_view grey = "#999999";

/// The colour of a method's precision, which is the same in all pictures.
[[nodiscard]] constexpr std::string_view colour_of(Precision precision) {
  switch (precision) {
    case Precision::binary32:
      return orange;
    case Precision::binary64:
      return blue;
    case Precision::extended:
      break;
  }
  return green;
}

/// In a dark page a picture is dark too: this rule inverts lightness, and keeps hues.
inline constexpr std::string_view dark_style =
    "@media (prefers-color-scheme: dark) { svg { filter: invert(0.93) hue-rotate(180deg) } }";

/// The distance of two names in a column, in font sizes.
inline constexpr double name_distance = 1.35;

/// The colour, darkened until text in it on white has a contrast of 4.5 (WCAG 2.2, 1.4.3).
[[nodiscard]] std::string readable(std::string_view colour);

/// Moves heights down until they are at least `gap` apart. Then moves the heights below `least` up again. Precondition:
/// the heights are sorted from the greatest.
void spread(std::vector<double>& heights, double gap, double least);

/// A gnuplot command for tics on an axis of times, at 1, 2 and 5 times the powers of ten if there is room, as plain
/// numbers.
[[nodiscard]] std::string time_tics(const Axis& axis);

/// "10⁻³".
[[nodiscard]] std::string power_of_ten(int exponent);

/// A gnuplot command for tics at powers of ten, about eight of them, on the axis 'x' or 'y'.
[[nodiscard]] std::string power_tics(const Axis& axis, char letter);

/// A text as gnuplot reads it between double quotes. gnuplot would run what stands between backquotes as a command, so
/// apostrophes replace backquotes. Spaces replace control characters.
[[nodiscard]] std::string gnuplot_text(std::string_view text);

}  // namespace carom::report
