// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include <carom/subjects/protocol/text.hpp>

#include "commands/commands.hpp"
#include "commands/interrupt.hpp"
#include "commands/progress.hpp"
#include "io/threads.hpp"
#include "plan/clock.hpp"
#include "plan/contacts_of_file.hpp"
#include "plan/plan_text.hpp"
#include "plan/spelling.hpp"

namespace carom::tool {

int plan_contacts(const PlanArguments& arguments) {
  const std::stop_token stop = stop_on_interrupt();
  const plan::RecordedContacts recorded = plan::contacts_of_file(arguments.file, stop);
  const Model law = arguments.law.empty() ? recorded.law.value_or(Model::rough) : *model_named(arguments.law);
  std::vector<properties::plan::Candidate> candidates;
  for (plan::SpelledCandidate& one : plan::spelled_candidates()) {
    candidates.push_back(std::move(one.candidate));
  }
  properties::plan::PlanOptions options;
  options.demand = {law, arguments.limit_ulps, arguments.digits, arguments.exact_law};
  options.workers = threads(arguments.jobs);
  options.clock = arguments.repetitions > 0 ? plan::clock_of(arguments.repetitions) : properties::plan::Clock();
  options.progress = progress_line("contacts");
  options.stop = stop;
  const plan::PlanRun run{arguments.file, options.demand, make_plan(recorded.contacts, candidates, options),
                          arguments.repetitions};
  if (arguments.format == "json") {
    fmt::print("{}\n", plan_record(run).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    const std::string text = arguments.format == "markdown" ? plan_markdown(run) : plan_text(run);
    fmt::print("{}", subjects::protocol::printable(text, text.size()));
  }
  return run.exit_status();
}

}  // namespace carom::tool
