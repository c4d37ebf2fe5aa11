// SPDX-License-Identifier: BSL-1.0
// The laws in impulse space (docs/guide/laws.md): impulse_space OUT
//
// The contact is planar. A body of mass 1 and moments 1 hits a fixed body at velocity (3, −4, 0). The contact point is
// at (1, −1, 0) from the body's centre. N = (0, 1, 0), ε = 1/2, μ = 1. The collision matrix in tangential and normal
// components is (2, 1; 1, 2).
#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/laws.hpp>

#include "io/gnuplot.hpp"
#include "support/exit_status.hpp"

namespace carom::figures {
namespace {

using Point = std::vector<double>;  // the tangential and the normal component of an impulse

Collision shown() {
  Collision c;
  c.a.position = {-1, 1, 0};
  c.a.velocity = {3, -4, 0};
  c.b.immovable = true;
  c.restitution = 0.5;
  c.friction = 1;
  return c;
}

Point point_of(const Vector3<double>& impulse) { return {impulse.x(), impulse.y()}; }

Point impulse_by(Law law, const Collision& collision) {
  const auto contact = impulse::make_contact<double>(collision);
  if (law == Law::coulomb) {
    return point_of(impulse::coulomb_impulse(contact).on_a);
  }
  Point point;
  impulse::with_law(law, [&](const auto& solver) { point = point_of(acting_impulse(solver(contact)).on_a); });
  return point;
}

/// A path of impulses from 0 to the law's impulse. Friction or restitution grows along the path.
std::vector<Point> path_of(Law law) {
  Collision c = shown();
  std::vector<Point> path{{0, 0}};
  if (law == Law::rough) {
    path.push_back(impulse_by(Law::frictionless, c));
    path.push_back(impulse_by(law, shown()));
    return path;
  }
  if (law == Law::coulomb) {
    path.push_back(impulse_by(Law::frictionless, c));
    for (c.friction = 0.0625; c.friction <= 1; c.friction += 0.0625) {
      path.push_back(impulse_by(law, c));
    }
    return path;
  }
  c.restitution = 0;
  path.push_back(impulse_by(law, c));
  path.push_back(impulse_by(law, shown()));
  return path;
}

report::Plot picture_of(Law law, std::string_view title) {
  report::Plot picture("impulse-space-" + std::string(name_of(law)), 660, 560, 17);
  const report::Panel panel{{-6, 3, false, 65, 470}, {-0.5, 7, false, 75, 505}};
  picture.begin(panel, title, "tangential component of F [N s]", "normal component of F [N s]");
  picture.add("set xtics 1\nset ytics 1");
  const auto line = [&](std::vector<Point> points, std::string_view style) {
    picture.curve(points, fmt::format("using 1:2 with lines {}", style));
  };
  const auto mark = [&](const Point& point, std::string_view text, std::string_view colour, double left, double up) {
    const report::Pixel at = panel.place_of(point[0], point[1]);
    picture.write(text, {at.x + left, at.y + up}, colour, "left");
  };
  const Collision c = shown();
  Collision plastic = c;
  plastic.restitution = 0;
  const Point stops_approach = impulse_by(Law::frictionless, plastic);
  const Point stops_point = impulse_by(Law::sticking, plastic);
  const Point answer = impulse_by(law, c);
  const bool has_friction = law == Law::rough || law == Law::coulomb;
  Collision smoother = c;
  smoother.friction = 0.5;
  const Point on_cone = impulse_by(law, smoother);
  std::vector<report::Label> names;
  const auto name_end = [&](std::string_view text, const Point& end, std::string_view colour) {
    names.push_back({std::string(text), panel.place_of(end[0], end[1]), std::string(colour)});
  };
  name_end("cone, μ = 1", {3, 3}, report::grey);
  name_end("N·V⁺ = −ε N·V⁻", {3, 1.5}, report::green);
  name_end("N·V⁺ = 0", {3, 0.5}, report::sky_blue);
  mark(stops_approach, "P_I", report::black, 10, -8);
  mark(stops_point, "P_II", report::black, 10, 4);
  mark(answer, "F", report::vermillion, 10, 16);
  if (has_friction) {
    mark(on_cone, "F at μ = 1/2", report::purple, 10, 16);
    name_end("cone, μ = 1/2", {3, 6}, report::purple);
  }
  picture.name_ends(names, panel);
  line({{-6, 6}, {0, 0}, {3, 3}}, fmt::format("lw 2 lc rgb '{}'", report::grey));
  line({{-6, 6}, {3, 1.5}}, fmt::format("lw 1.5 dt 2 lc rgb '{}'", report::green));
  line({{-6, 5}, {3, 0.5}}, fmt::format("lw 1.5 dt 2 lc rgb '{}'", report::sky_blue));
  if (has_friction) {
    line({{-3.5, 7}, {0, 0}, {3, 6}}, fmt::format("lw 1.5 dt 3 lc rgb '{}'", report::purple));
  }
  line(path_of(law), fmt::format("lw 3 lc rgb '{}'", report::vermillion));
  picture.curve({stops_approach, stops_point},
                fmt::format("using 1:2 with points pt 7 ps 0.9 lc rgb '{}'", report::black));
  picture.curve({answer}, fmt::format("using 1:2 with points pt 7 ps 1.3 lc rgb '{}'", report::vermillion));
  if (has_friction) {
    picture.curve({on_cone}, fmt::format("using 1:2 with points pt 7 ps 0.9 lc rgb '{}'", report::purple));
  }
  picture.end();
  return picture;
}

int run(int argc, char** argv) {
  if (argc != 2) {
    throw std::invalid_argument("expected one argument, the directory to write to");
  }
  const std::array pictures{
      picture_of(Law::frictionless, "frictionless: along N, (1+ε) P_I"),
      picture_of(Law::reflection, "reflection: the tangential velocity is kept"),
      picture_of(Law::sticking, "sticking: P_II, and on by ε"),
      picture_of(Law::rough, "rough: (1+ε) P_I, then along P_II − P_I"),
      picture_of(Law::coulomb, "coulomb: as friction grows, until the point sticks"),
  };
  const std::filesystem::path directory = argv[1];
  std::filesystem::create_directories(directory / "gnuplot");
  tool::draw(pictures, directory);
  return 0;
}

}  // namespace
}  // namespace carom::figures

int main(int argc, char** argv) {
  return carom::unit::exit_status("impulse_space", [&] { return carom::figures::run(argc, argv); });
}
