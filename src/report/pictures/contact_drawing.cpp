// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/collision.hpp>
#include <carom/collision/expects.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/report/pictures/contact_drawing.hpp>
#include <carom/report/pictures/markup.hpp>

namespace carom::report {
namespace {

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

/// Far larger than any picture.
constexpr long double largest_coordinate = 1000;

/// A coordinate in the drawing, also for numbers that are NaN or too large.
std::string in_pixels(long double number) {
  return fmt::format("{:.1f}", std::isnan(number) ? 0.0L : std::clamp(number, -largest_coordinate, largest_coordinate));
}

/// In SVG, y points downwards.
std::string point(const Place& place) { return in_pixels(place.x) + ',' + in_pixels(-place.y); }

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
  constexpr long double width_of_letter = 7.5L;
  const auto letters =
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; });
  const long double width = width_of_letter * static_cast<long double>(letters);
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
  const long double length = std::min(std::hypot(to.x - from.x, to.y - from.y), largest_coordinate);
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

// The plane has numbers in long double, so that differences and squares of any binary64 numbers neither overflow nor
// underflow.
using Direction = Vector3<long double>;

struct Plane {
  Direction across;
  Direction up;                 // along the normal
  std::string_view spanned_by;  // in words
};

/// The outline, projected into the plane, of the uniform ellipsoid with the body's mass and inertia.
struct Outline {
  long double longer = 0;  // semi-axes [m]
  long double shorter = 0;
  long double turned = 0;  // angle of the longer axis, counter-clockwise from `across` [rad]
};

/// The unit vector of a vector; zero for a zero vector.
Direction unit(const Direction& vector) {
  const long double largest = vector.cwiseAbs().maxCoeff();
  return largest > 0 ? Direction((vector / largest).normalized()) : Direction(Direction::Zero());
}

/// The unit vector of `vector`, without the component along the normal.
Direction askew(const Direction& vector, const Direction& normal) {
  const Direction direction = unit(vector);
  return direction - direction.dot(normal) * normal;
}

Direction any_orthogonal(const Direction& normal) {
  int smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  return askew(Direction::Unit(smallest), normal).normalized();
}

/// The plane of the normal N and of a second vector. The second vector is the relative velocity or a movable body's
/// lever arm, whichever is least parallel to N. Precondition: the numbers are finite and the normal is not zero.
Plane contact_plane(const Collision& collision, const Vector3<double>& relative_velocity) {
  CAROM_EXPECTS(collision.normal.allFinite() && !collision.normal.isZero(0), collision.normal);
  struct Candidate {
    Direction askew;
    std::string_view name;
  };
  const Direction normal = unit(collision.normal.cast<long double>());
  Candidate best{askew(relative_velocity.cast<long double>(), normal), "the velocity of the contact point"};
  for (const auto& [body, name] :
       {std::pair{&collision.a, "the lever arm of A"}, std::pair{&collision.b, "the lever arm of B"}}) {
    const Direction arm = collision.point.cast<long double>() - body->position.cast<long double>();
    const Candidate candidate{askew(arm, normal), name};
    if (!body->immovable && candidate.askew.norm() > best.askew.norm()) {
      best = candidate;
    }
  }
  // A length below `visible` is rounding error of the subtraction in `askew`.
  constexpr long double visible = 1e-12L;
  return best.askew.norm() > visible ? Plane{best.askew.normalized(), normal, best.name}
                                     : Plane{any_orthogonal(normal), normal, "any direction orthogonal to N"};
}

Place projected(const Plane& plane, const Direction& vector) {
  return {vector.dot(plane.across), vector.dot(plane.up)};
}

/// Precondition: the body is movable and valid.
Outline outline(const Plane& plane, const Body& body) {
  CAROM_EXPECTS(!body.immovable && body.mass > 0 && body.principal_inertia.minCoeff() > 0, body.mass,
                body.principal_inertia);
  const Direction inertia = body.principal_inertia.cast<long double>();
  const Quaternion<long double> orientation = body.orientation.cast<long double>();
  // A uniform ellipsoid with semi-axes a, b and c has I_x = m (b² + c²) / 5, and so on. Hence a² = 5 (I_y + I_z − I_x)
  // / 2m. The matrix of the outline is Σ p pᵀ, over the semi-axes p projected into the plane.
  long double xx = 0;
  long double xy = 0;
  long double yy = 0;
  for (int i = 0; i < 3; ++i) {
    const long double squared = 5 * (inertia.sum() - 2 * inertia[i]) / (2 * static_cast<long double>(body.mass));
    const Place axis = projected(plane, oracles::turned<long double>(orientation, Direction::Unit(i)));
    const long double kept = std::max(squared, 0.0L);  // some valid bodies have the inertia of no ellipsoid
    xx += kept * axis.x * axis.x;
    xy += kept * axis.x * axis.y;
    yy += kept * axis.y * axis.y;
  }
  const long double mean = (xx + yy) / 2;
  const long double spread = std::hypot((xx - yy) / 2, xy);
  return {std::sqrt(mean + spread), std::sqrt(std::max(mean - spread, 0.0L)), std::atan2(2 * xy, xx - yy) / 2};
}

constexpr long double reach_in_pixels = 85;  // of the longest lever arm
constexpr long double arrow_in_pixels = 75;  // of the longest velocity, except for a computed one that is far longer
constexpr long double wall_in_pixels = 95;   // half of a wall
constexpr long double normal_in_pixels = 55;

long double length(const Place& place) { return std::hypot(place.x, place.y); }
Place scaled(const Place& place, long double factor) { return {place.x * factor, place.y * factor}; }

/// The velocities before, computed and exact, projected into the plane.
struct Velocities {
  Place before;
  std::optional<Place> computed;
  std::optional<Place> exact;
};

template <class Pick>
Velocities seen(const Plane& plane, const ContactPicture& picture, const Pick& pick) {
  const auto place = [&](const Motion& motion) {
    return projected(plane, Direction(pick(motion).template cast<long double>()));
  };
  Velocities velocities{place(picture.before), std::nullopt, std::nullopt};
  if (picture.computed) {
    velocities.computed = place(*picture.computed);
  }
  if (picture.exact) {
    velocities.exact = place(*picture.exact);
  }
  return velocities;
}

/// The longest velocity [m/s], which scales all arrows. Computed velocities count only if all other velocities are 0.
long double longest_of(const std::vector<Velocities>& all) {
  long double true_ones = 0;
  long double computed = 0;
  for (const Velocities& one : all) {
    true_ones = std::max({true_ones, length(one.before), one.exact ? length(*one.exact) : 0});
    computed = std::max(computed, one.computed ? length(*one.computed) : 0);
  }
  return true_ones > 0 ? true_ones : computed;
}

/// `whose` begins the name of each arrow. Returns whether an arrow was shortened.
bool draw_velocities(Drawing& drawing, const Place& at, const Velocities& velocities, long double longest,
                     const std::string& whose) {
  const long double scale = longest > 0 ? arrow_in_pixels / longest : 0;
  constexpr long double longest_arrow = 2 * arrow_in_pixels;
  bool is_shortened = false;
  drawing.arrow(at, scaled(velocities.before, scale), "before", whose + "before");
  if (velocities.computed) {
    const Place computed = scaled(*velocities.computed, scale);
    is_shortened = length(computed) > longest_arrow;
    drawing.arrow(at, is_shortened ? scaled(computed, longest_arrow / length(computed)) : computed, "computed",
                  whose + "computed");
  }
  if (velocities.exact) {
    drawing.arrow(at, scaled(*velocities.exact, scale), "exact", whose + "exact");
  }
  return is_shortened;
}

/// A body to draw. Places are in pixels, and the contact point is the origin.
struct DrawnBody {
  const Body* body;
  std::string name;
  int side;  // 1: the normal points to it
  Place centre;
  bool has_centre;  // whether the centre is near enough to be drawn
  Outline outline;
  Velocities velocities;
};

/// Pixels for a metre, so that both lever arms fit. The outlines fit too if they are not much larger.
long double length_scale(const std::vector<DrawnBody>& bodies) {
  long double reach = 0;
  long double size = 0;
  for (const DrawnBody& one : bodies) {
    if (!one.body->immovable) {
      reach = std::max(reach, length(one.centre));
      size = std::max(size, one.outline.longer);
    }
  }
  constexpr long double largest_outline = 2.5;  // in lengths of the longest lever arm
  const long double whole = reach > 0 ? std::max(reach, std::min(size, largest_outline * reach)) : size;
  return whole > 0 ? reach_in_pixels / whole : 0;
}

/// Scales the outline to pixels and limits it to a visible size. Returns whether it is to scale.
bool scale_outline(Outline& outline, long double scale) {
  constexpr long double smallest = 5;
  constexpr long double largest = 130;
  const Outline whole{outline.longer * scale, outline.shorter * scale, outline.turned};
  outline = {std::clamp(whole.longer, smallest, largest), std::clamp(whole.shorter, smallest, largest), whole.turned};
  return outline.longer == whole.longer && outline.shorter == whole.shorter;
}

std::string sentence(bool applies, const char* text) { return applies ? std::string(" ") + text : ""; }

std::string scale_sentence(long double longest) {
  return longest > 0
             ? fmt::format(" An arrow as long as N is {:.2g} m/s.", longest * normal_in_pixels / arrow_in_pixels)
             : "";
}

/// Returns the caption.
std::string draw_bodies(pugi::xml_node parent, const ContactPicture& picture, const Plane& plane,
                        const std::string& name, const std::string& title) {
  const Collision& collision = picture.collision;
  std::vector<DrawnBody> bodies;
  for (const bool is_a : {true, false}) {
    const Body& body = is_a ? collision.a : collision.b;
    const Direction to_centre = body.position.cast<long double>() - collision.point.cast<long double>();
    const Velocities velocities = seen(plane, picture, [&](const Motion& motion) {
      return is_a ? motion.outcome.a.velocity : motion.outcome.b.velocity;
    });
    bodies.push_back({&body, is_a ? "A" : "B", is_a ? 1 : -1, projected(plane, to_centre), true,
                      body.immovable ? Outline{} : outline(plane, body), velocities});
  }
  Drawing drawing(parent, name, title + ": the bodies",
                  fmt::format("The contact point, the normal (upwards), and the centres of both bodies with their "
                              "velocities before and after the impulse, in the plane of the normal and {}.",
                              plane.spanned_by));
  const long double scale = length_scale(bodies);
  bool is_to_scale = true;
  for (DrawnBody& one : bodies) {
    one.centre = scaled(one.centre, scale);
    if (one.body->immovable) {
      one.has_centre = length(one.centre) <= 2 * reach_in_pixels;
      drawing.wall(one.side, wall_in_pixels);
    } else {
      is_to_scale = scale_outline(one.outline, scale) && is_to_scale;
      drawing.ellipse(one.centre, one.outline.longer, one.outline.shorter, one.outline.turned, "body");
    }
  }
  for (const DrawnBody& one : bodies) {
    if (!one.body->immovable) {
      drawing.line(one.centre, {0, 0}, "arm");
    }
  }
  drawing.arrow({0, 0}, {0, normal_in_pixels}, "normal", "N");
  const long double longest = longest_of({bodies[0].velocities, bodies[1].velocities});
  bool is_shortened = false;
  for (const DrawnBody& one : bodies) {
    const Place from = one.has_centre ? one.centre : Place{wall_in_pixels / 2, 0};
    is_shortened = draw_velocities(drawing, from, one.velocities, longest, one.name + " ") || is_shortened;
    if (one.has_centre) {
      drawing.dot(one.centre, "centre");
    }
  }
  drawing.dot({0, 0}, "point");
  drawing.label({0, 0}, "P");
  for (const DrawnBody& one : bodies) {
    drawing.label(one.has_centre ? one.centre : Place{-wall_in_pixels + 10, one.side * 10.0L},
                  one.name + (one.body->immovable ? " (wall)" : ""));
  }
  drawing.finish();
  return fmt::format("Bodies and the velocities of their centres, in the plane of N and {}.{}{}{}", plane.spanned_by,
                     scale_sentence(longest), sentence(!is_to_scale, "An outline is not to scale."),
                     sentence(is_shortened, "The drawing shortens a computed velocity."));
}

std::string draw_relative_velocity(pugi::xml_node parent, const ContactPicture& picture, const Plane& plane,
                                   const std::string& name, const std::string& title) {
  Drawing drawing(
      parent, name, title + ": the contact point",
      "The velocity of A relative to B at the contact point before and after the impulse. The normal points upwards.");
  const Velocities velocities = seen(plane, picture, [](const Motion& motion) { return motion.relative_velocity; });
  const long double longest = longest_of({velocities});
  drawing.line({-wall_in_pixels, 0}, {wall_in_pixels, 0}, "surface");
  drawing.arrow({0, 0}, {0, normal_in_pixels}, "normal", "N");
  const bool is_shortened = draw_velocities(drawing, {0, 0}, velocities, longest, "");
  drawing.dot({0, 0}, "point");
  drawing.label({0, 0}, "0");
  drawing.finish();
  const auto is_zero = [](const std::optional<Place>& place) { return place && length(*place) == 0; };
  return "Relative velocity of the contact point, V = V_A − V_B, drawn from 0." + scale_sentence(longest) +
         sentence(is_shortened, "The drawing shortens the computed velocity.") +
         sentence(is_zero(velocities.computed), "The computed velocity is zero.") +
         sentence(is_zero(velocities.exact), "The exact velocity is zero.");
}

}  // namespace

void add_contact_figure(pugi::xml_node parent, const ContactPicture& picture, const std::string& name,
                        const std::string& title) {
  const Plane plane = contact_plane(picture.collision, picture.before.relative_velocity);
  const pugi::xml_node figures = add(parent, "div", {{"class", "drawings"}});
  const pugi::xml_node bodies = add(figures, "figure");
  const std::string of_bodies = draw_bodies(bodies, picture, plane, name + "-bodies", title);
  add(bodies, "figcaption", {}, of_bodies);
  const pugi::xml_node relative = add(figures, "figure");
  const std::string of_contact = draw_relative_velocity(relative, picture, plane, name + "-contact", title);
  add(relative, "figcaption", {}, of_contact + (picture.computed ? "" : " There is no finite computed outcome."));
}

}  // namespace carom::report
