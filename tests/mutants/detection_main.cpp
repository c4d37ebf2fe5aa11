// SPDX-License-Identifier: BSL-1.0
// Prints which conditional mutants the gate's cases kill:
//
//  detection [--seed S] [--cases N] [--jobs J] [--law L…] [--format text|markdown]
//
// The exit status is 1 if a sound outcome is rejected. --planted prints which invariants reject each planted mutant,
// and which mutants would survive without each invariant.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "detection_report.hpp"
#include "planted.hpp"

namespace carom::mutants {
namespace {

int run(int argc, char** argv) {
  DetectionOptions options;
  options.jobs = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::string> laws;
  std::string format = "text";
  bool planted = false;
  CLI::App app("Which conditional mutants the cases of the gate kill");
  app.add_option("--seed", options.seed)->capture_default_str();
  app.add_option("--cases", options.cases, "Of each family, times its weight")->capture_default_str();
  app.add_option("--jobs", options.jobs, "Threads")->check(CLI::PositiveNumber);
  app.add_option("--law", laws, "Laws (default: all that determine an outcome)");
  app.add_option("--format", format)->check(CLI::IsMember({"text", "markdown"}))->capture_default_str();
  app.add_flag("--planted", planted, "Which invariants reject each planted mutant, in Markdown");
  try {
    app.parse(argc, argv);
    if (!laws.empty()) {
      options.laws.clear();
      for (const std::string& name : laws) {
        const std::optional<Law> law = law_named(name);
        if (!law || !determines_outcome(*law)) {
          throw CLI::ValidationError("--law", "there is no law \"" + name + "\" that determines an outcome");
        }
        options.laws.push_back(*law);
      }
    }
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  if (planted) {
    fmt::print("{}", to_markdown(rejected_mutants(options.seed, options.cases, options.jobs)));
    return 0;
  }
  const Detection detection = detect(options);
  fmt::print("{}", to_text(detection, format == "markdown"));
  return detection.sound_rejected() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace carom::mutants

int main(int argc, char** argv) {
  try {
    return carom::mutants::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "detection: %s\n", error.what());
    return 2;
  }
}
