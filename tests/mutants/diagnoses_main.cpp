// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>

#include "catalogue.hpp"
#include "io/threads.hpp"

/// Prints the gate's diagnosis of each planted mutant, or of each named mutant, next to the defect.
int main(int argc, char** argv) {
  using namespace carom;
  properties::GateOptions options;
  options.cases = 1000;
  options.shrinks = false;
  options.workers = tool::threads(0);
  for (const properties::Family& family : properties::all_families()) {
    options.families.push_back(&family);
  }
  std::vector<Subject> subjects;
  std::vector<const mutants::Mutant*> planted;
  for (const mutants::Mutant& mutant : mutants::all_mutants()) {
    const bool is_named =
        argc == 1 || std::any_of(argv + 1, argv + argc, [&](const char* name) { return mutant.name == name; });
    if (is_named) {
      subjects.push_back(subject_of(mutant));
      planted.push_back(&mutant);
    }
  }
  const properties::GateReport report = run_gate(subjects, options);
  for (std::size_t s = 0; s < planted.size(); ++s) {
    std::printf("%s (%s): %s\n", std::string(planted[s]->name).c_str(), std::string(name_of(planted[s]->law)).c_str(),
                std::string(planted[s]->sentence).c_str());
    if (report.results[s].violated_invariants().empty()) {
      std::printf("  nothing is violated\n");
      continue;
    }
    const auto begin = std::chrono::steady_clock::now();
    const auto found = properties::diagnosis::diagnose(report.results[s], report);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    std::printf("  %s (%lu of %lu), diagnosed in %.2f s\n", std::string(found.telling->name).c_str(), found.telling_in,
                found.violated, time.count());
    for (const properties::diagnosis::Fault& fault : found.faults) {
      std::printf("  %s\n  %s\n  look at: %s\n", fault.what.c_str(), fault.where.c_str(), fault.look_at.c_str());
    }
    std::fflush(stdout);
  }
}
