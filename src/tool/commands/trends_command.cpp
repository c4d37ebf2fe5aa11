// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/output_file.hpp"
#include "compare/read_report.hpp"
#include "compare/trend.hpp"
#include "compare/trend_html.hpp"
#include "compare/trend_markdown.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

/// Each report.json in the directory or below it, and what else in it ends in .json.
std::set<fs::path> reports_in(const fs::path& directory) {
  std::set<fs::path> files;
  const fs::directory_options skipping = fs::directory_options::skip_permission_denied;
  for (auto entry = fs::recursive_directory_iterator(directory, skipping); entry != fs::recursive_directory_iterator();
       ++entry) {
    const bool is_report =
        entry->path().filename() == "report.json" || (entry.depth() == 0 && entry->path().extension() == ".json");
    if (is_report && entry->is_regular_file()) {
      files.insert(entry->path());
    }
  }
  return files;
}

/// Without those that were named before.
std::vector<std::string> files_of(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  const auto add = [&](const std::string& file) {
    if (std::find(files.begin(), files.end(), file) == files.end()) {
      files.push_back(file);
    }
  };
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
      add(path);
      continue;
    }
    try {
      for (const fs::path& file : reports_in(path)) {
        add(file.string());
      }
    } catch (const fs::filesystem_error& error) {
      throw UsageError(fmt::format("{}: cannot be read: {}", compare::shown(path), error.code().message()));
    }
  }
  return files;
}

}  // namespace

int show_trends(const TrendsArguments& arguments) {
  std::vector<compare::ReadReport> reports;
  std::vector<std::string> unread;
  for (const std::string& file : files_of(arguments.paths)) {
    try {
      reports.push_back(compare::read_report(file));
    } catch (const UsageError& error) {
      unread.emplace_back(compare::shown(error.what()));
    }
  }
  if (reports.empty() && unread.empty()) {
    throw UsageError("there is no report.json where you said");
  }
  const compare::Trends trends = compare::trends_of(std::move(reports));
  const std::string html = compare::trends_html(trends, unread);
  const std::string markdown = compare::trends_markdown(trends, unread);
  fmt::print("{}", arguments.format == "html" ? html : markdown);
  std::fflush(stdout);  // what was read is not lost where the files cannot be written
  if (!arguments.out.empty()) {
    make_directories(arguments.out);
    write_file(fs::path(arguments.out) / "trends.html", html);
    write_file(fs::path(arguments.out) / "trends.md", markdown);
  }
  for (const std::string& why : unread) {
    fmt::print(stderr, "carom: not read: {}\n", why);
  }
  return unread.empty() ? exit_all_hold : exit_usage;
}

}  // namespace carom::tool
