// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <carom/report/pictures/contact_drawing.hpp>
#include <carom/report/pictures/contact_plane.hpp>
#include <carom/report/pictures/drawing.hpp>
#include <carom/report/pictures/markup.hpp>

namespace carom::report {
namespace {

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
