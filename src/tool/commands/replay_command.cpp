// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/json/text.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/report/pages/shown_case.hpp>
#include <carom/subjects/protocol/spelling.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/input_file.hpp"
#include "io/interrupt.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

using report::ReplayedCase;
using subjects::protocol::spelling_count;

/// Runs the task. An exception becomes a UsageError that names the subject, unless it is a fault of the judge.
template <class Task>
auto in_its_name(const Subject& subject, const Task& task) {
  try {
    return task();
  } catch (const oracles::JudgeError&) {
    throw;
  } catch (const std::exception& error) {
    throw UsageError(fmt::format("{}: {}", subject.name, error.what()));
  }
}

/// Limits the restarts of a failing program. Each failure is a finding, and a program that hangs takes the full
/// timeout.
constexpr unsigned most_failures = 100;

bool names_subject(const ReadCollision& read) { return read.witness && !read.witness->subject.empty(); }

/// The verdicts of the claimed invariants that compare all answers with the first answer.
std::vector<properties::NamedVerdict> session_verdicts(const properties::Claim& claim, properties::Sameness sameness,
                                                       const std::vector<ReplayedCase>& cases) {
  std::vector<properties::NamedVerdict> verdicts;
  for (const properties::Invariant* invariant : claim.invariants) {
    if (const auto* about = std::get_if<properties::AboutSession>(&invariant->about)) {
      properties::NamedVerdict& named = verdicts.emplace_back(properties::NamedVerdict{invariant, {}});
      for (const ReplayedCase& other : cases) {
        if (named.verdict.status == properties::Status::holds) {
          named.verdict = about->check(cases.front().answer, other.answer, sameness);
        }
      }
    }
  }
  return verdicts;
}

/// A subject with its sessions. A program has one session for each spelling (a way to write a request in JSON,
/// subjects/protocol/spelling.hpp), because a fault of its JSON reader may show in one spelling alone. A program that
/// reads hexadecimal numbers has as many sessions, so that `memoryless` is judged.
class ReplaySubject {
 public:
  /// Throws UsageError if the subject cannot be run.
  ReplaySubject(const std::string& name, double timeout_seconds, const oracles::Limits& limits,
                const properties::Domain& within, const std::stop_token& stop) {
    const unsigned spellings = runs_in_this_process(name) ? 1 : spelling_count;
    for (unsigned spelling = 0; spelling < spellings; ++spelling) {
      Subject subject = subject_from_argument(name, timeout_seconds, stop, spelling);
      if (!subject.absent.empty()) {
        throw UsageError(fmt::format("{} is absent: {}", name, subject.absent));
      }
      sessions_.push_back(in_its_name(
          subject, [&] { return properties::open_restarting(subject, restarts_->emplace_back(most_failures), stop); }));
      subject_ = std::move(subject);
    }
    claim_ = properties::claim_of(subject_, limits);
    claim_.within = within;
  }

  [[nodiscard]] const Subject& subject() const { return subject_; }
  [[nodiscard]] const properties::Claim& claim() const { return claim_; }

  /// Judges the case in every spelling. Returns the result of the first spelling with a violation, otherwise of the
  /// first spelling. For a program, the invariant `memoryless` holds if the answers in all spellings are the same.
  /// Throws UsageError.
  [[nodiscard]] ReplayedCase judge(const properties::Case& one) {
    std::vector<ReplayedCase> cases;
    for (Session& session : sessions_) {
      auto [answer, judgement] =
          in_its_name(subject_, [&] { return properties::judge_in_session(claim_, session, one); });
      cases.push_back({std::move(answer), std::move(judgement)});
    }
    const auto shows = [](const ReplayedCase& replayed) { return report::is_violated(replayed.judgement); };
    const auto found = std::find_if(cases.begin(), cases.end(), shows);
    const auto chosen = static_cast<std::size_t>((found == cases.end() ? cases.begin() : found) - cases.begin());
    ReplayedCase result = cases[chosen];
    if (cases.size() > 1) {
      const std::vector<properties::NamedVerdict> verdicts =
          session_verdicts(claim_, properties::sameness_of_answers(subject_), cases);
      result.judgement.verdicts.insert(result.judgement.verdicts.end(), verdicts.begin(), verdicts.end());
    }
    if (subject_.spellings > 1) {
      result.spellings = cases.size();
      result.violated_spellings = static_cast<std::size_t>(std::count_if(cases.begin(), cases.end(), shows));
      result.spelt = subjects::protocol::spelt(one.collision, static_cast<unsigned>(chosen));
    }
    return result;
  }

  /// Throws UsageError if a session does not end properly.
  void close() {
    for (Session& session : sessions_) {
      in_its_name(subject_, [&session] { session.close(); });
    }
  }

 private:
  Subject subject_;
  properties::Claim claim_;
  // On the heap, because sessions refer to the elements and this object may be moved.
  std::unique_ptr<std::deque<properties::Restarts>> restarts_ = std::make_unique<std::deque<properties::Restarts>>();
  std::vector<Session> sessions_;  // one for each spelling of a program, otherwise one
};

struct ReplayArguments {
  std::string file;               // empty if a case of a family is replayed
  bool drawn = false;             // whether to replay the drawn collision of a witness
  std::string family;             // the family whose case is replayed in place of a file
  std::uint64_t case_number = 0;  // in the family
  std::uint64_t seed = 1;
  std::optional<properties::Domain> within = {};  // of the case and of related collisions
  std::string subject;                            // empty: the one that a witness names
  double timeout = 5;                             // for each reply of a program [s]
  LimitArguments judged;
  bool shows_all_laws = false;  // whether to show laws that the subject does not claim
  std::string format = "text";
};

/// The subjects of a replay, each started once.
class ReplaySubjects {
 public:
  ReplaySubjects(const ReplayArguments& arguments, std::stop_token stop)
      : arguments_(arguments), stop_(std::move(stop)) {}

  /// The subject that judges this collision: the one of the command line, otherwise the one that the file names;
  /// nullptr if there is none. Throws UsageError.
  [[nodiscard]] ReplaySubject* subject_for(const ReadCollision& read) {
    if (!arguments_.subject.empty()) {
      return &named(arguments_.subject);
    }
    const bool may_be_judged = names_subject(read) && runs_in_this_process(read.witness->subject);
    return may_be_judged ? &named(read.witness->subject) : nullptr;
  }

  /// The reason why no subject judges the collision although the file names one: a file cannot start programs.
  /// Otherwise empty.
  [[nodiscard]] std::string why_none(const ReadCollision& read) const {
    if (!arguments_.subject.empty() || !names_subject(read) || runs_in_this_process(read.witness->subject)) {
      return {};
    }
    return fmt::format("not judged: the subject of the witness is a program; to run it, use --subject {}",
                       printable_line(quoted(read.witness->subject), 4000));
  }

  void close() {
    for (auto& [name, open] : open_) {
      open.close();
    }
  }

 private:
  ReplaySubject& named(const std::string& name) {
    const auto found = open_.find(name);
    if (found != open_.end()) {
      return found->second;
    }
    ReplaySubject subject(name, arguments_.timeout, arguments_.judged.limits(),
                          arguments_.within.value_or(properties::Domain()), stop_);
    return open_.emplace(name, std::move(subject)).first->second;
  }

  const ReplayArguments& arguments_;
  std::stop_token stop_;
  std::map<std::string, ReplaySubject> open_;
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
  ReplaySubjects subjects(arguments, stop);
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
  add_domain_option(
      *command, "--within", arguments->within,
      "The domain into which the case was drawn, and in which related collisions lie (default: everything)");
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
