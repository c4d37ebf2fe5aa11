// SPDX-License-Identifier: BSL-1.0
// Measured rebound angles compared with the laws (docs/findings/impacts.md): oblique_impact DATA OUT
//
// DATA has comment lines that begin with '#', one line of column names, and lines "incidence,rebound". These are the
// angles, in degrees, of the velocity of the contact patch before and after the impact. The figure uses the sphere and
// the coefficients of the measurement.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/rough.hpp>
#include <carom/impulse/solve3.hpp>

#include "io/gnuplot.hpp"
#include "support/exit_status.hpp"

namespace carom::figures {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double shown = 0.34;  // e_t in the chart and the table

struct Angles {
  double incidence;
  double rebound;
};

std::vector<Angles> read_angles(const std::filesystem::path& file) {
  std::ifstream input(file);
  if (!input) {
    throw std::invalid_argument(file.string() + " cannot be read");
  }
  std::vector<Angles> angles;
  std::string line;
  for (int number = 1; std::getline(input, line); ++number) {
    if (line.empty() || line[0] == '#' || line.starts_with("incidence")) {
      continue;
    }
    std::istringstream words(line);
    Angles read{};
    char comma = ' ';
    if (!(words >> read.incidence >> comma >> read.rebound) || comma != ',' || !(words >> std::ws).eof()) {
      throw std::invalid_argument(
          fmt::format("{}:{}: expected two numbers with a comma between", file.string(), number));
    }
    angles.push_back(read);
  }
  if (angles.empty()) {
    throw std::invalid_argument(file.string() + ": no angles");
  }
  return angles;
}

/// A 5 mm sphere of aluminium oxide at 3.9 m/s, ε = 0.98, μ = 0.092.
Collision impact(double incidence, double tangential_restitution) {
  constexpr double radius = 0.0025;
  constexpr double density = 4000;  // [kg/m³]; the angles do not depend on it
  Collision c;
  c.a.mass = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
  c.a.principal_inertia.setConstant(c.a.mass * radius * radius * 2 / 5);
  c.a.position = {0, radius, 0};
  c.a.velocity = {3.9 * std::sin(incidence * degree), -3.9 * std::cos(incidence * degree), 0};
  c.b.immovable = true;
  c.restitution = 0.98;
  c.friction = 0.092;
  c.tangential_restitution = tangential_restitution;
  return c;
}

double rebound(const Collision& c, const Outcome<double>& after) {
  const Vector3<double> patch = after.a.velocity + after.a.angular_velocity.cross(c.point - c.a.position);
  return std::atan2(patch.x(), patch.y()) / degree;
}

double rough_rebound(double incidence, double tangential_restitution) {
  const Collision c = impact(incidence, tangential_restitution);
  return rebound(c, impulse::rough<impulse::Ldlt>(impulse::make_contact<double>(c)));
}

double coulomb_rebound(double incidence) {
  const Collision c = impact(incidence, 0);
  return rebound(c, impulse::coulomb(impulse::make_contact<double>(c)));
}

using ReboundAngle = std::function<double(double)>;

double largest_difference(const std::vector<Angles>& measured, const ReboundAngle& rebound_angle) {
  double largest = 0;
  for (const Angles& angles : measured) {
    largest = std::max(largest, std::abs(rebound_angle(angles.incidence) - angles.rebound));
  }
  return largest;
}

std::vector<std::vector<double>> curve_of(const ReboundAngle& rebound_angle) {
  std::vector<std::vector<double>> points;
  for (double incidence = 0.5; incidence < 89.6; incidence += 0.5) {
    points.push_back({incidence, rebound_angle(incidence)});
  }
  return points;
}

report::Plot picture_of(const std::vector<Angles>& measured) {
  report::Plot picture("oblique-impact", 900, 620, 16);
  const report::Panel panel{{0, 90, false, 80, 870}, {-20, 90, false, 70, 560}};
  picture.begin(panel, "A 5 mm sphere of aluminium oxide on glass at 3.9 m/s: ε = 0.98, μ = 0.092",
                "angle of incidence of the contact patch [degrees]", "angle of its rebound [degrees]");
  picture.add("set xtics 10\nset ytics 10");
  const auto text = [&](std::string_view words, double x, double y, std::string_view colour) {
    picture.write(words, panel.place_of(x, y), colour);
  };
  text("rough, e_t = −1: no friction", 13, 49, report::grey);
  text("rough, e_t = 0, which is coulomb here", 36, -1, report::blue);
  text("rough, e_t = 0.34", 28, -10, report::vermillion);
  text("measured, ± 1° (Gorham, Kharaz 2000)", 52, 29, report::black);
  const auto curve = [&](double restitution, std::string_view colour) {
    picture.curve(curve_of([=](double incidence) { return rough_rebound(incidence, restitution); }),
                  fmt::format("using 1:2 with lines lw 3 lc rgb '{}'", colour));
  };
  curve(-1, report::grey);
  curve(0, report::blue);
  curve(shown, report::vermillion);
  std::vector<std::vector<double>> points;
  for (const Angles& angles : measured) {
    points.push_back({angles.incidence, angles.rebound});
  }
  picture.curve(points, fmt::format("using 1:2:(1) with yerrorbars pt 7 ps 0.8 lw 1.5 lc rgb '{}'", report::black));
  picture.end();
  return picture;
}

int run(int argc, char** argv) {
  if (argc != 3) {
    throw std::invalid_argument("expected two arguments, the measured angles and the directory to write to");
  }
  const std::vector<Angles> measured = read_angles(argv[1]);
  fmt::print(
      "| incidence | measured | rough, e_t = {} | rough, e_t = 0 | coulomb |\n| ---: | ---: | ---: | ---: | ---: |\n",
      shown);
  for (const Angles& angles : measured) {
    fmt::print("| {:.1f}° | {:.1f}° | {:.1f}° | {:.1f}° | {:.1f}° |\n", angles.incidence, angles.rebound,
               rough_rebound(angles.incidence, shown), rough_rebound(angles.incidence, 0),
               coulomb_rebound(angles.incidence));
  }
  const auto difference_at = [&](double restitution) {
    return largest_difference(measured, [=](double x) { return rough_rebound(x, restitution); });
  };
  double best = 0;
  for (int hundredths = 1; hundredths <= 100; ++hundredths) {
    best = difference_at(hundredths / 100.0) < difference_at(best) ? hundredths / 100.0 : best;
  }
  fmt::print("\nlargest difference: {:.2f}° with e_t = {}, {:.2f}° with 0, least with {}, {:.2f}°\n",
             difference_at(shown), shown, difference_at(0), best, difference_at(best));
  const report::Plot picture = picture_of(measured);
  const std::filesystem::path directory = argv[2];
  std::filesystem::create_directories(directory / "gnuplot");
  tool::draw({&picture, 1}, directory);
  return 0;
}

}  // namespace
}  // namespace carom::figures

int main(int argc, char** argv) {
  return carom::unit::exit_status("oblique_impact", [&] { return carom::figures::run(argc, argv); });
}
