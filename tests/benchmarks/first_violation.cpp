// SPDX-License-Identifier: BSL-1.0
// Measures the time that a gate needs to find a defect and to shrink the witness. The gate ends at the first violation.
//
//  first_violation                    for the planted defects, in this process
//  first_violation 'exec:PROGRAM…'    for a program, including its starts
//  first_violation --families         ranks the families for properties/gate/task.cpp
#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>

#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/protocol/exec.hpp>

#include "mutants/catalogue.hpp"
#include "mutants/rejection.hpp"
#include "support/exit_status.hpp"

namespace carom::benchmarks {
namespace {

constexpr int runs = 5;  // for each subject

struct Find {
  double milliseconds;
  double of_processor;   // [ms], of this process and its finished children
  std::string violated;  // the invariant; empty if there is no violation
};

double processor_time() {
  double sum = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
      sum += 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
    }
  }
  return sum;
}

template <class Open>
Find first_find(const Open& open) {
  properties::GateOptions options;
  options.fail_fast = true;
  for (const properties::Family& family : properties::all_families()) {
    options.families.push_back(&family);
  }
  const double processor_before = processor_time();
  const auto start = std::chrono::steady_clock::now();
  const properties::GateReport report = properties::run_gate({open()}, options);
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  const std::vector<std::string> violated = names_of(report.results.at(0).violated_invariants());
  return {elapsed.count(), processor_time() - processor_before, violated.empty() ? std::string() : violated.front()};
}

template <class Open>
Find median_find(const Open& open) {
  std::vector<Find> finds;
  for (int run = 0; run < runs; ++run) {
    finds.push_back(first_find(open));
  }
  std::nth_element(finds.begin(), finds.begin() + runs / 2, finds.end(),
                   [](const Find& x, const Find& y) { return x.milliseconds < y.milliseconds; });
  return finds[runs / 2];
}

void print(const std::string& name, const Find& find) {
  fmt::print("{:40} {:8.1f} ms {:8.1f} ms of processor  {}\n", name, find.milliseconds, find.of_processor,
             find.violated.empty() ? "not found" : find.violated);
}

int time_mutants() {
  std::vector<double> times;
  std::vector<double> of_processor;
  for (const mutants::Mutant& mutant : mutants::all_mutants()) {
    const Find find = median_find([&] { return mutants::subject_of(mutant); });
    print(std::string(mutant.name), find);
    times.push_back(find.milliseconds);
    of_processor.push_back(find.of_processor);
  }
  std::sort(times.begin(), times.end());
  std::sort(of_processor.begin(), of_processor.end());
  fmt::print(
      "{} defects: median {:.1f} ms ({:.1f} of processor), nine in ten within {:.1f} ms ({:.1f}), all {:.1f} ms\n",
      times.size(), times[times.size() / 2], of_processor[times.size() / 2], times[times.size() * 9 / 10],
      of_processor[times.size() * 9 / 10], times.back());
  return 0;
}

int time_program(const std::string& specification) {
  print(specification, median_find([&] { return subjects::protocol::exec_subject(specification, {}); }));
  return 0;
}

/// Ranks families greedily. It takes the family whose first two cases find most of the remaining defects, removes these
/// defects, and repeats.
int rank_families() {
  constexpr std::uint64_t seeds = 8;
  constexpr std::uint64_t cases = 2;
  using Defect = std::pair<std::string_view, std::uint64_t>;  // a mutant and a seed
  std::map<std::string_view, std::set<Defect>> found;         // by family
  std::vector<Subject> subjects;
  for (const mutants::Mutant& mutant : mutants::all_mutants()) {
    subjects.push_back(mutants::subject_of(mutant));
  }
  for (const properties::Family& family : properties::all_families()) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const auto rejecting = mutants::rejecting_invariants(subjects, std::span(&family, 1), seed, cases);
      for (std::size_t i = 0; i < subjects.size(); ++i) {
        if (!rejecting[i].empty()) {
          found[family.name].emplace(mutants::all_mutants()[i].name, seed);
        }
      }
    }
    found[family.name];
  }
  std::set<Defect> done;
  while (!found.empty()) {
    const auto left = [&](const std::set<Defect>& of_family) {
      return std::count_if(of_family.begin(), of_family.end(), [&](const Defect& x) { return !done.contains(x); });
    };
    const auto best = std::max_element(found.begin(), found.end(), [&](const auto& x, const auto& y) {
      return std::pair(left(x.second), x.second.size()) < std::pair(left(y.second), y.second.size());
    });
    fmt::print("{:20} {:4} of those left, {:4} of all {}\n", best->first, left(best->second), best->second.size(),
               mutants::all_mutants().size() * seeds);
    done.insert(best->second.begin(), best->second.end());
    found.erase(best);
  }
  return 0;
}

int run(int argc, char** argv) {
  const std::string argument = argc > 1 ? argv[1] : "";
  if (argument.empty()) {
    return time_mutants();
  }
  return argument == "--families" ? rank_families() : time_program(argument);
}

}  // namespace
}  // namespace carom::benchmarks

int main(int argc, char** argv) {
  return carom::unit::exit_status("first_violation", [&] { return carom::benchmarks::run(argc, argv); });
}
