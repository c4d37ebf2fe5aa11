// SPDX-License-Identifier: BSL-1.0
// Prints the share of the triples of features that occur in the cases of a gate:
//
//  triples [--seed S] [--cases N] [--jobs J] [--missing K]
//
// It draws N cases of each family, times the family's weight, as `carom gate --cases N` does. It prints intermediate
// results.
#include <algorithm>
#include <cstdint>
#include <exception>
#include <iostream>
#include <random>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/properties/families/family.hpp>

#include "triples.hpp"

namespace carom::properties {
namespace {

/// For each family of weight w, adds the cases first·w + offset, first·w + offset + step, … below last·w.
void add_cases(TripleCoverage& coverage, std::uint64_t seed, std::uint64_t first, std::uint64_t last,
               std::uint64_t offset, std::uint64_t step) {
  for (const Family& family : all_families()) {
    const auto weight = static_cast<std::uint64_t>(family.weight);
    for (std::uint64_t i = first * weight + offset; i < last * weight; i += step) {
      const Collision collision = drawn_case(family, seed, i).collision;
      if (validate(collision).empty() && oracles::ExactCase(collision).approach() == oracles::Approach::colliding) {
        coverage.add(collision);
      }
    }
  }
}

int run(int argc, char** argv) {
  std::uint64_t seed = 1;
  std::uint64_t cases = 20000;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  std::size_t shown = 10;
  CLI::App app("Which share of the triples of features the cases of a gate have");
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--cases", cases, "Of each family, times its weight")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--jobs", jobs, "Threads")->check(CLI::PositiveNumber);
  app.add_option("--missing", shown, "How many of those not met to show")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const std::uint64_t feasible = TripleCoverage::feasible();
  fmt::print("{} triples of features of which each pair is feasible\n", feasible);
  std::vector<TripleCoverage> coverage(jobs);
  std::uint64_t done = 0;
  for (std::uint64_t next = std::min<std::uint64_t>(1000, cases); done < cases; next = std::min(2 * next, cases)) {
    std::vector<std::thread> threads;
    for (unsigned job = 0; job < jobs; ++job) {
      threads.emplace_back([&, job] { add_cases(coverage[job], seed, done, next, job, jobs); });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    done = next;
    for (unsigned job = 1; job < jobs; ++job) {
      coverage[0] |= coverage[job];
    }
    const std::uint64_t met = coverage[0].met();
    fmt::print("{:>9} cases of each family: {} met, {:.2f} %\n", done, met,
               100 * static_cast<double>(met) / static_cast<double>(feasible));
    std::cout.flush();
  }
  std::vector<TripleCoverage::Triple> missing = coverage[0].missing();
  std::ranges::shuffle(missing, std::mt19937_64(seed));
  missing.resize(std::min(shown, missing.size()));
  for (const auto& [x, y, z] : missing) {
    fmt::print("  not met: {}, {}, {}\n", x->name, y->name, z->name);
  }
  return 0;
}

}  // namespace
}  // namespace carom::properties

int main(int argc, char** argv) {
  try {
    return carom::properties::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "triples: " << error.what() << '\n';
    return 2;
  }
}
