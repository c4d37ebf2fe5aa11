// SPDX-License-Identifier: BSL-1.0
#include <memory>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>

#include "commands/options.hpp"
#include "commands/plan.hpp"
#include "io/input_file.hpp"
#include "io/interrupt.hpp"
#include "io/output.hpp"
#include "io/threads.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

bool is_scene(const std::string& text) {
  try {
    const nlohmann::json record = parse_json(text);
    return record.is_object() && record.contains("duration");
  } catch (const FormatError&) {
    return false;  // JSON Lines, or a defect that the later reader reports better
  }
}

/// The contacts of a file: the collisions that for_each_collision reads, or the impacts of a scene if
/// `contacts_of_scene` is set. A collision is kept if its only defects are ε, μ or e_t out of range. Throws UsageError
/// that names the file, the place, the field, and what was expected. Throws UsageError, too, if the user stopped.
plan::RecordedContacts contacts_of_file(const std::string& file, const plan::ContactsOfScene& contacts_of_scene,
                                        const std::stop_token& stop) {
  JsonFile read_file(file, stop);
  if (!read_file.is_lines() && is_scene(read_file.whole())) {
    if (!contacts_of_scene) {
      throw UsageError(fmt::format("{}: this file is a scene; to plan it, install carom-scene", file));
    }
    return contacts_of_scene(read_file.whole(), file, stop);
  }
  plan::RecordedContacts recorded;
  for_each_collision(read_file, OutOfRange::kept, [&](const ReadCollision& read) {
    recorded.contacts.push_back({read.contact_class, read.one.collision, read.place});
  });
  return recorded;
}

struct PlanArguments {
  std::string file;
  std::string law;         // the name of a law other than `any`; empty: the scene's own, otherwise rough
  double limit_ulps = 32;  // of binary64
  std::optional<int> digits;
  bool exact_law = false;
  int repetitions = 5;  // of each timing; 0: nothing is timed
  unsigned jobs = 0;    // threads that judge; 0: one for each core
  std::string format = "text";
};

int plan_contacts(const PlanArguments& arguments, const plan::ContactsOfScene& contacts_of_scene) {
  const std::stop_token stop = stop_on_interrupt();
  const plan::RecordedContacts recorded = contacts_of_file(arguments.file, contacts_of_scene, stop);
  const Law law = arguments.law.empty() ? recorded.law.value_or(Law::rough) : *law_named(arguments.law);
  properties::plan::PlanOptions options;
  options.demand = {law, arguments.limit_ulps, arguments.digits, arguments.exact_law};
  options.workers = threads(arguments.jobs);
  options.clock = arguments.repetitions > 0 ? plan::clock_of(arguments.repetitions) : properties::plan::Clock();
  options.progress = progress_line("contacts");
  options.stop = stop;
  const plan::PlanRun run{arguments.file, options.demand, make_plan(recorded.contacts, plan::candidates(), options),
                          arguments.repetitions};
  if (arguments.format == "json") {
    fmt::print("{}\n", plan_record(run).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    const std::string text = plan_text(run);
    fmt::print("{}", carom::printable(text, text.size()));
  }
  return run.exit_status();
}

}  // namespace

void add_plan_with(CLI::App& app, Chosen& chosen, plan::ContactsOfScene contacts_of_scene) {
  const auto arguments = std::make_shared<PlanArguments>();
  std::vector<std::string> laws;
  for (const Law law : all_laws) {
    if (law != Law::any) {
      laws.emplace_back(name_of(law));
    }
  }
  CLI::App* command =
      app.add_subcommand("plan",
                         "Find the least law, precision, solve, frame and batch form that serve the contacts of a "
                         "file; exit status 0 something serves, 1 nothing does, 2 usage error or bad input");
  command
      ->add_option("FILE", arguments->file,
                   "A scene, or collisions: JSON Lines, one object or an array. The field \"class\" names the class of "
                   "a contact")
      ->required();
  command
      ->add_option("--law", arguments->law, "The required law (default: the law of the scene, or rough for collisions)")
      ->check(CLI::IsMember(laws));
  add_accuracy(*command, arguments->limit_ulps, arguments->digits,
               "Largest permitted backward error, in ulps of binary64",
               "Required number of correct digits of the velocity change, in place of --limit-ulps");
  command->add_flag("--exact-law", arguments->exact_law,
                    "Allow a lesser law only if it equals the required law exactly on every contact");
  command
      ->add_option("--repetitions", arguments->repetitions,
                   "Number of repetitions of each timing. With 0, nothing is timed, and the order of laws, precisions "
                   "and solves determines the least method")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  add_jobs(*command, arguments->jobs, "Number of threads that judge");
  add_format(*command, arguments->format, {"text", "json"});
  command->callback([&chosen, arguments, contacts_of_scene = std::move(contacts_of_scene)] {
    chosen = [arguments, contacts_of_scene] { return plan_contacts(*arguments, contacts_of_scene); };
  });
}

void add_plan(CLI::App& app, Chosen& chosen) { add_plan_with(app, chosen, {}); }

}  // namespace carom::tool
