// SPDX-License-Identifier: BSL-1.0
// verdicts [CASES [SEED]]: judges the solvers of src/subjects/methods and all mutants, and prints a line of JSON for each.
// The line has the status, the counts of each family, the witnesses, and figures of three digits. This program is built
// for this machine and for WebAssembly. same_verdicts_test.py compares what both print.
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/properties/families/family.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/methods/method_groups.hpp>

#include "mutants/catalogue.hpp"

namespace {

using nlohmann::json;

std::vector<carom::Subject> judged_subjects() {
  using namespace carom::subjects;
  std::vector<carom::Subject> subjects;
  for (const auto group : {float_methods, double_methods, double_double_methods, pivoting_float_methods,
                           pivoting_double_methods, refined_methods, guaranteed_methods}) {
    for (const Method& method : group()) {
      subjects.push_back(method.subject);
    }
  }
  for (const carom::mutants::Mutant& mutant : carom::mutants::all_mutants()) {
    subjects.push_back(subject_of(mutant));
  }
  return subjects;
}

json family_record(const carom::properties::FamilyResult& result) {
  json record = {{"cases", result.cases}, {"worst", fmt::format("{:.3g}", result.worst_backward_error)}};
  for (const auto& [invariant, count] : result.counts) {
    record["counts"][invariant] = {count.holds, count.violated, count.skipped};
  }
  return record;
}

json record_of(const carom::properties::SubjectResult& result, const carom::properties::GateOptions& options) {
  json record = {{"subject", result.subject.name},
                 {"error", result.error},
                 {"not_judged", result.not_judged},
                 {"sound", result.is_sound()},
                 {"witnesses", json::object()}};
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    record["families"][std::string(options.families[f]->name)] = family_record(result.families[f]);
  }
  for (const carom::properties::Witness& witness : result.witnesses) {
    record["witnesses"][witness.invariant] = {{"family", witness.family},
                                              {"case", witness.index},
                                              {"collision", carom::collision_to_json(witness.shrunk.collision)},
                                              {"residual", fmt::format("{:.3g}", witness.verdict.residual)},
                                              {"allowed", fmt::format("{:.3g}", witness.verdict.allowed)}};
  }
  if (const auto digits = result.digits_at_least(0.5)) {
    record["digits"] = fmt::format("{:.3g}", *digits);
  }
  return record;
}

}  // namespace

int main(int count, char** words) {
  carom::properties::GateOptions options;
  options.cases = count > 1 ? std::stoull(words[1]) : 50;
  options.seed = count > 2 ? std::stoull(words[2]) : 1;
  options.relations_every = 1;
  for (const carom::properties::Family& family : carom::properties::all_families()) {
    options.families.push_back(&family);
  }
  for (const carom::Subject& subject : judged_subjects()) {
    const carom::properties::GateReport report = carom::properties::run_gate({subject}, options);
    fmt::print("{}\n", record_of(report.results[0], options).dump());
    std::fflush(stdout);
  }
}
