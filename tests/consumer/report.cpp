// SPDX-License-Identifier: BSL-1.0
#include <carom/impulse/frictionless.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/kit/subject.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/results/run_json.hpp>

int main() {
  const auto solver = [](const carom::impulse::Contact<double>& contact) {
    return carom::impulse::frictionless(contact);
  };
  carom::properties::GateOptions options;
  options.cases = 20;
  options.families = carom::properties::pointers_to(carom::properties::all_families());
  const auto found =
      carom::properties::run_gate({carom::conformance::subject("mine", carom::Law::frictionless, solver)}, options);
  const carom::report::Run run = carom::report::diagnosed({found, {}, {}, {}, {true}, {}});
  const carom::report::RecordedRun read = carom::report::recorded_run(carom::report::report_record(run), "report");
  return run.exit_status() == 0 && is_sound_throughout(overall_of(run)) && read.subjects.size() == 1 &&
                 carom::report::run_html(run, "").find("mine") != std::string::npos
             ? 0
             : 1;
}
