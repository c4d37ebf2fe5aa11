// SPDX-License-Identifier: BSL-1.0
#include <ctime>
#include <exception>
#include <stop_token>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/kit/gate_diagnosis.hpp>

namespace carom::conformance {
namespace {

/// A hint needs few cases. A relation multiplies the questions to a subject, and explains nothing that others do not.
constexpr std::uint64_t cases_of_each_family = 100;
constexpr std::uint64_t relations_every = 10;
constexpr std::clock_t longest =
    4 * CLOCKS_PER_SEC;                // of processor time, so that other programs do not shorten the run
constexpr std::size_t most_lines = 9;  // after the heading

}  // namespace

std::string gate_diagnosis(const Suite& suite) {
  std::stop_source stop;
  properties::GateOptions options;
  options.cases = cases_of_each_family;
  options.families = suite.families;
  options.within = suite.within;
  options.limits = suite.yardstick.limits();
  options.relations_every = relations_every;
  options.shrinks = false;
  options.stop = stop.get_token();
  options.progress = [&, start = std::clock()](std::uint64_t, std::uint64_t) {
    if (std::clock() - start > longest) {
      stop.request_stop();
    }
  };
  try {
    const properties::GateReport report = properties::run_gate({suite.subject}, options);
    const properties::SubjectResult& result = report.results.front();
    if (result.violated_invariants().empty()) {
      return {};
    }
    const properties::diagnosis::Diagnosis diagnosis = properties::diagnosis::diagnose(result, report);
    return "  The gate's diagnosis, of " + std::to_string(result.cases()) + " cases:\n" +
           properties::diagnosis::in_words(diagnosis.faults, "    ", most_lines);
  } catch (const std::exception& error) {
    return std::string("  No diagnosis: ") + error.what() + '\n';
  }
}

}  // namespace carom::conformance
