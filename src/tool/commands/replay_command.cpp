// SPDX-License-Identifier: BSL-1.0
#include <memory>

#include <fmt/format.h>

#include <carom/collision/json/text.hpp>
#include <carom/properties/domains/draw_within.hpp>
#include <carom/properties/gate/posed_families.hpp>
#include <carom/report/pages/shown_case.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/input_file.hpp"
#include "io/interrupt.hpp"
#include "io/json_file.hpp"
#include "io/orphans.hpp"
#include "io/replay_subjects.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

struct ReplayArguments {
  std::string file;               // empty if a case of a family is replayed
  bool drawn = false;             // whether to replay the drawn collision of a witness
  std::string family;             // the family whose case is replayed in place of a file
  std::uint64_t case_number = 0;  // in the family
  std::uint64_t seed = 1;
  std::optional<properties::Domain> within = {};  // of the case
  std::string subject;                            // empty: the one that a witness names
  double timeout = 5;                             // for each reply of a program [s]
  LimitArguments judged;
  bool shows_all_laws = false;  // whether to show laws that the subject does not claim
  std::string format = "text";
};

using nlohmann::json;

/// The case that the gate draws from the family with this seed and number.
ReadCollision numbered_case(const ReplayArguments& arguments) {
  const properties::Family& family = properties::require_family("--family", arguments.family);
  return {fmt::format("{} #{} of seed {}", family.name, arguments.case_number, arguments.seed),
          properties::drawn_case_within(arguments.within.value_or(properties::Domain()), family, arguments.seed,
                                        arguments.case_number),
          std::nullopt};
}

/// The law that the judged subject claims. If no subject is judged, the law of the witness, otherwise `any`.
Law claimed_law(const ReadCollision& read, const ReplaySubject* open) {
  if (open != nullptr) {
    return open->subject().law;
  }
  return read.witness && read.witness->law ? *read.witness->law : Law::any;
}

/// Shows the collision. Returns whether the subject violates an invariant on it.
bool replay_one(const ReadCollision& read, const ReplayArguments& arguments, ReplaySubjects& subjects) {
  ReplaySubject* const open = subjects.subject_for(read);
  report::CaseToShow to_show{read.place, read.one, arguments.shows_all_laws ? Law::any : claimed_law(read, open),
                             !arguments.judged.exact};
  to_show.why_not_judged = subjects.why_none(read);
  std::optional<report::ReplayedCase> replayed;
  if (open != nullptr) {
    replayed = open->judge(read.one);
    to_show.judged = {&open->subject(), &open->claim().yardstick, &*replayed};
  }
  const report::ShownCase shown = report::shown_case(to_show);
  if (arguments.format == "json") {
    fmt::print("{}\n", shown.record.dump(-1, ' ', false, json::error_handler_t::replace));
  } else {
    fmt::print("{}\n", printable(shown.text, shown.text.size()));
  }
  return replayed && report::is_violated(replayed->judgement);
}

int replay(const ReplayArguments& arguments) {
  const std::stop_token stop = stop_on_interrupt();
  const Orphanage orphanage;
  ReplaySubjects subjects(arguments.subject, arguments.timeout, arguments.judged.limits(),
                          arguments.within.value_or(properties::Domain()), stop);
  bool violated = false;
  const auto visit = [&](const ReadCollision& read) {
    if (stop.stop_requested()) {
      throw UsageError(fmt::format("stopped by the user before {}", read.place));
    }
    violated = replay_one(read, arguments, subjects) || violated;
  };
  if (!arguments.family.empty()) {
    visit(numbered_case(arguments));
  } else {
    JsonFile file(arguments.file, stop);
    for_each_collision(file, OutOfRange::refused, visit, arguments.drawn ? OfWitness::drawn : OfWitness::shrunk);
  }
  subjects.close();
  return violated ? exit_violated : exit_all_hold;
}

}  // namespace

void add_replay(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command =
      app.add_subcommand("replay", "Show each step of the exact outcome of collisions, and judge a subject on them");
  CLI::Option* replayed_file =
      command->add_option("FILE", arguments->file, "Witnesses or collisions: JSON Lines, one object or an array");
  command->add_flag("--drawn", arguments->drawn, "Use the collision of a witness as it was drawn, before shrinking")
      ->needs(replayed_file);
  CLI::Option* replayed_family =
      command->add_option("--family", arguments->family, "The family of a case, in place of FILE")
          ->excludes(replayed_file);
  CLI::Option* replayed_case =
      command->add_option("--case", arguments->case_number, "The number of the case, from 0; needs --family")
          ->check(is_count);
  replayed_case->needs(replayed_family);
  replayed_family->needs(replayed_case);
  command->add_option("--seed", arguments->seed, "The seed of the case; needs --family")
      ->check(is_count)
      ->capture_default_str()
      ->needs(replayed_family);
  add_domain_option(*command, "--within", arguments->within,
                    "The domain into which the case was drawn (default: everything); needs --family")
      ->needs(replayed_family);
  command->add_option("--subject", arguments->subject,
                      "Subject to judge (default: the subject of the witness, unless it is a program)");
  command->add_flag("--all-laws", arguments->shows_all_laws,
                    "Show the outcome of every law, not only of the law that the subject claims");
  add_limits(*command, arguments->judged);
  add_timeout(*command, arguments->timeout);
  add_format(*command, arguments->format, {"text", "json"});
  command->callback([&chosen, arguments] {
    if (arguments->file.empty() && arguments->family.empty()) {
      throw CLI::RequiredError("FILE, or --family and --case");
    }
    chosen = [arguments] { return replay(*arguments); };
  });
}

}  // namespace carom::tool
