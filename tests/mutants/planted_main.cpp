// SPDX-License-Identifier: BSL-1.0
// Prints which invariants reject each planted mutant, in Markdown:
//
//  planted [--seed S] [--cases N] [--jobs J]
//
// --shortcuts prints in how many cases of a default run each shortcut is rejected, with the seeds 1, 2 and 3.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "planted.hpp"
#include "shortcuts.hpp"

namespace {

void print_shortcuts() {
  const std::uint64_t most = 1000;
  const std::vector<double> thresholds = carom::mutants::drawn_thresholds(1);
  std::array<std::vector<std::uint64_t>, 3> rejecting;
  for (std::uint64_t seed = 1; seed <= rejecting.size(); ++seed) {
    rejecting[seed - 1] = carom::mutants::rejecting_cases(thresholds, seed, most);
  }
  const auto in_words = [most](std::uint64_t cases) {
    return cases < most ? std::to_string(cases) : fmt::format("≥ {}", most);
  };
  fmt::print("| special value | law | the solver | t | seed 1 | seed 2 | seed 3 |\n");
  fmt::print("| --- | --- | --- | ---: | ---: | ---: | ---: |\n");
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    const carom::mutants::Shortcut& shortcut = carom::mutants::all_shortcuts()[i];
    fmt::print("| `{}` | {} | {} | {:.1e} | {} | {} | {} |\n", shortcut.name, name_of(shortcut.law), shortcut.sentence,
               thresholds[i], in_words(rejecting[0][i]), in_words(rejecting[1][i]), in_words(rejecting[2][i]));
  }
}

int run(int argc, char** argv) {
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  bool shortcuts = false;
  CLI::App app("Which invariants reject each planted mutant, and which mutants each invariant alone rejects");
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--cases", cases, "Of each family, times its weight")->capture_default_str();
  app.add_option("--jobs", jobs, "Threads")->check(CLI::PositiveNumber);
  app.add_flag("--shortcuts", shortcuts, "In how many cases each shortcut is rejected, with the seeds 1 to 3");
  CLI11_PARSE(app, argc, argv);
  if (shortcuts) {
    print_shortcuts();
    return 0;
  }
  fmt::print("{}", to_markdown(carom::mutants::rejected_mutants(seed, cases, jobs)));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "planted: %s\n", error.what());
    return 2;
  }
}
