// SPDX-License-Identifier: BSL-1.0
// Writes the generated sections of docs/reference/three-properties.md:
//
//  three_properties PAGE [--engines REPORT.json]
//
// Without a report, the sections on engines do not change.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "three_properties_page.hpp"

namespace carom::mutants {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream input(file);
  if (!input) {
    throw std::runtime_error(file + " cannot be read");
  }
  return {std::istreambuf_iterator<char>(input), {}};
}

int run(int argc, char** argv) {
  std::string file;
  std::string report;
  CLI::App app("Writes the sections of docs/reference/three-properties.md that are generated");
  app.add_option("PAGE", file, "The page, which is written in place")->required();
  app.add_option("--engines", report, "report.json of `carom gate --engines`");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  PlantedRun planted;
  planted.jobs = std::max(1U, std::thread::hardware_concurrency());
  std::string page = text_of(file);
  for (const properties::Property& property : properties::three_properties()) {
    const std::string name(property.name);
    page = with_section(page, "facts " + name, facts_section(property));
    page = with_section(page, "planted " + name, planted_section(property, planted));
    if (!report.empty()) {
      page = with_section(page, "engines " + name, engines_section(property, nlohmann::json::parse(text_of(report))));
    }
  }
  std::ofstream(file) << page;
  return 0;
}

}  // namespace
}  // namespace carom::mutants

int main(int argc, char** argv) {
  try {
    return carom::mutants::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "three_properties: %s\n", error.what());
    return 2;
  }
}
