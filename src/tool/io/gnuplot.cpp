// SPDX-License-Identifier: BSL-1.0
#include "io/gnuplot.hpp"

#include <fmt/format.h>

#include <carom/report/pictures/plot.hpp>
#include <carom/subjects/protocol/child.hpp>

#include "io/input_file.hpp"
#include "io/output.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

void add_dark_style(const std::filesystem::path& svg) {
  std::string text = content_of_file(svg.string());
  const std::size_t begin = text.find("<g ");
  if (begin == std::string::npos) {
    throw UsageError(fmt::format("{}: gnuplot wrote no picture into this file", svg.string()));
  }
  text.insert(begin, fmt::format("<style>{}</style>\n", report::dark_style));
  write_file(svg, text);
}

void draw(std::span<const report::Plot> pictures, const std::filesystem::path& directory) {
  const std::filesystem::path scripts = directory / "gnuplot";
  make_directories(scripts);
  for (const report::Plot& picture : pictures) {
    write_file(scripts / (picture.name() + ".gp"), picture.script());
  }
  // gnuplot doubles a quote inside single quotes.
  std::string change_directory = "cd '";
  for (const char letter : directory.string()) {
    change_directory += letter == '\'' ? "''" : std::string(1, letter);
  }
  change_directory += '\'';
  subjects::protocol::ChildLimits limits;
  limits.timeout = std::chrono::minutes(1);
  for (const report::Plot& picture : pictures) {
    try {
      subjects::protocol::ChildProcess gnuplot({"gnuplot", "-e", change_directory, "gnuplot/" + picture.name() + ".gp"},
                                               limits, {});
      try {
        gnuplot.finish("");
        add_dark_style(directory / (picture.name() + ".svg"));
      } catch (const subjects::protocol::ChildError& error) {
        throw UsageError(fmt::format("gnuplot {}: {}", error.what(), gnuplot.standard_error()));
      }
    } catch (const subjects::protocol::ChildError& error) {
      throw UsageError(
          fmt::format("{}: the data and the scripts are written, but {}.svg was not drawn; install gnuplot, or run the "
                      "scripts in gnuplot/",
                      error.what(), picture.name()));
    }
  }
}

}  // namespace

std::exception_ptr try_to_draw(std::span<const report::Plot> pictures, const std::filesystem::path& directory) {
  try {
    draw(pictures, directory);
    return nullptr;
  } catch (const UsageError&) {
    return std::current_exception();
  }
}

}  // namespace carom::tool
