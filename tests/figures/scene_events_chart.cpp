// SPDX-License-Identifier: BSL-1.0
// Events per second by the number of spheres (docs/internals/performance.md): scene_events_chart DATA OUT
//
// DATA is the output of tests/benchmarks/scene_events: one line of column names, then lines
// "spheres,median,least,most".
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/gnuplot.hpp"
#include "support/exit_status.hpp"

namespace carom::figures {
namespace {

using Rows = std::vector<std::vector<double>>;

Rows read_rows(const std::filesystem::path& file) {
  std::ifstream input(file);
  if (!input) {
    throw std::invalid_argument(file.string() + " cannot be read");
  }
  Rows rows;
  std::string line;
  std::getline(input, line);
  for (int number = 2; std::getline(input, line); ++number) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    std::vector<double> row(4);
    if (!(words >> row[0] >> row[1] >> row[2] >> row[3]) || !(words >> std::ws).eof()) {
      throw std::invalid_argument(fmt::format("{}:{}: expected four numbers", file.string(), number));
    }
    rows.push_back(row);
  }
  if (rows.empty()) {
    throw std::invalid_argument(file.string() + ": no figures");
  }
  return rows;
}

report::Plot picture_of(const Rows& rows) {
  report::Plot picture("scene-events", 900, 520, 16);
  double most = 0;
  for (const std::vector<double>& row : rows) {
    most = std::max(most, row[3]);
  }
  const report::Panel panel{{80, 160'000, true, 90, 870}, {0, 1.1 * most / 1000, false, 70, 460}};
  picture.begin(panel, "A gas of elastic spheres at volume fraction 0.2", "number of spheres",
                "events a second of a core [thousands]");
  picture.add(report::power_tics(panel.x, 'x') + "\nset ytics 100");
  picture.write("median of the rounds, their least and most", panel.place_of(4000, 0.76 * most / 1000), report::blue);
  Rows medians;
  Rows ranges;
  for (const std::vector<double>& row : rows) {
    medians.push_back({row[0], row[1] / 1000});
    ranges.push_back({row[0], row[1] / 1000, row[2] / 1000, row[3] / 1000});
  }
  picture.curve(medians, fmt::format("using 1:2 with lines lw 3 lc rgb '{}'", report::blue));
  picture.curve(ranges, fmt::format("using 1:2:3:4 with yerrorbars pt 7 ps 0.8 lw 1.5 lc rgb '{}'", report::blue));
  picture.end();
  return picture;
}

int run(int argc, char** argv) {
  if (argc != 3) {
    throw std::invalid_argument("expected two arguments, the figures and the directory to write to");
  }
  const report::Plot picture = picture_of(read_rows(argv[1]));
  const std::filesystem::path directory = argv[2];
  std::filesystem::create_directories(directory / "gnuplot");
  tool::draw({&picture, 1}, directory);
  return 0;
}

}  // namespace
}  // namespace carom::figures

int main(int argc, char** argv) {
  return carom::unit::exit_status("scene_events_chart", [&] { return carom::figures::run(argc, argv); });
}
