// SPDX-License-Identifier: BSL-1.0
// Measures the diagnosis on defects that a seed draws: carom_drawn_defects [--seed S] [--cases N] [--singles N]
// [--pairs N]
//
// Prints each solver with the faults that the gate names, then the totals. Solvers with one defect come first, then
// solvers with two. Exit status 1: a sound solver is violated, no defect is named, or a complete run misses a goal.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>

#include "drawn_defects.hpp"
#include "io/threads.hpp"
#include "support/changed_subject.hpp"
#include "support/exit_status.hpp"

namespace carom::mutants {
namespace {

using properties::GateReport;
using properties::SubjectResult;
using properties::diagnosis::Diagnosis;
using properties::diagnosis::Fault;

constexpr std::uint64_t complete_singles = 100;
constexpr std::uint64_t complete_pairs = 40;

struct Settings {
  std::uint64_t seed = 1;
  std::uint64_t cases = 60;
  std::uint64_t singles = complete_singles;
  std::uint64_t pairs = complete_pairs;
};

struct Planted {
  std::uint64_t number;
  Law law;
  std::vector<DrawnDefect> defects;
};

Subject subject_of(const Planted& planted) {
  std::string name(name_of(planted.law));
  std::vector<DrawnChange> changes;
  for (const DrawnDefect& defect : planted.defects) {
    name.append("+").append(defect.kind);
    changes.push_back(defect.change);
  }
  return changed_solver(std::move(name), planted.law, std::move(changes));
}

/// Judges relations seldom: a diagnosis rests on single answers.
GateReport judged(const std::vector<Subject>& subjects, std::uint64_t cases) {
  constexpr std::uint64_t seldom = 50;
  properties::GateOptions options = unit::gate_options(cases);
  options.shrinks = false;
  options.relations_every = seldom;
  options.workers = tool::threads(2);
  return run_gate(subjects, options);
}

struct Share {
  std::uint64_t violated = 0;
  std::uint64_t judged = 0;
};

Share violated_share(const SubjectResult& result) {
  Share share;
  for (const properties::FamilyResult& family : result.families) {
    share.violated += family.violated;
    share.judged += family.judged();
  }
  return share;
}

/// A defect that spoils at least 1 % of the cases alone.
DrawnDefect frequent_defect(Law law, Random& random) {
  constexpr std::uint64_t few = 10;
  for (;;) {
    DrawnDefect defect = drawn_defect(law, random);
    const Share share = violated_share(judged({subject_of({0, law, {defect}})}, few).results[0]);
    if (100 * share.violated >= share.judged) {
      return defect;
    }
  }
}

/// Whether a solver can have both defects.
bool are_compatible(const DrawnDefect& x, const DrawnDefect& y) {
  const auto both_are = [&]<class Function>(Function) {
    return std::holds_alternative<Function>(x.change.change) && std::holds_alternative<Function>(y.change.change);
  };
  return x.kind != y.kind && !both_are(ComputeImpulse()) && !both_are(TestApproach());
}

/// The solver of this number. Its random numbers do not depend on the number of solvers.
Planted drawn_solver(const Settings& settings, std::uint64_t number) {
  if (number == settings.singles + 1) {
    return {number, Law::frictionless, threshold_and_world_axes()};
  }
  constexpr std::uint64_t most_solvers = 1'000'000;
  Random random(settings.seed * most_solvers + number);
  const Law law = drawn_laws[random.below(drawn_laws.size())];
  if (number <= settings.singles) {
    return {number, law, {drawn_defect(law, random)}};
  }
  Planted planted{number, law, {frequent_defect(law, random)}};
  while (planted.defects.size() < 2) {
    DrawnDefect second = frequent_defect(law, random);
    if (are_compatible(planted.defects[0], second)) {
      planted.defects.push_back(std::move(second));
    }
  }
  return planted;
}

struct Totals {
  std::uint64_t solvers = 0;
  std::uint64_t violated = 0;
  std::uint64_t named_first = 0;
  std::uint64_t named = 0;  // every defect, by any fault
  std::uint64_t with_false = 0;
};

/// Prints the solver and its faults, and counts them. A fault is false if it describes no planted defect and is not
/// the only one.
void count(const Planted& planted, const SubjectResult& result, const std::vector<Fault>& faults, Totals& totals) {
  using Relation = bool (*)(const Fault&, const DrawnDefect&);
  const auto is_of_planted = [&](const Fault& fault, Relation is_of) {
    return std::ranges::any_of(planted.defects, [&](const DrawnDefect& defect) { return is_of(fault, defect); });
  };
  const auto is_true = [&](const Fault& fault) { return is_of_planted(fault, describes); };
  const auto is_named = [&](const DrawnDefect& defect) {
    return std::ranges::any_of(faults, [&](const Fault& fault) { return names(fault, defect); });
  };
  const Share share = violated_share(result);
  const bool all_named = std::ranges::all_of(planted.defects, is_named);
  const bool has_false = faults.size() > 1 && !std::ranges::all_of(faults, is_true);
  ++totals.solvers;
  totals.violated += share.violated > 0 ? 1 : 0;
  totals.named_first += !faults.empty() && is_of_planted(faults[0], names) ? 1 : 0;
  totals.named += all_named ? 1 : 0;
  totals.with_false += has_false ? 1 : 0;
  fmt::print("{:>3} {}: {} of {} cases; {}{}\n", planted.number, name_of(planted.law), share.violated, share.judged,
             all_named ? "named" : "not named", has_false ? ", with a false fault" : "");
  for (const DrawnDefect& defect : planted.defects) {
    fmt::print("      planted {}: {}{}\n", defect.kind, defect.words, is_named(defect) ? "" : " (not named)");
  }
  for (const Fault& fault : faults) {
    fmt::print("      {} {} {}\n", is_true(fault) ? "+" : "-", fault.what, fault.where);
  }
}

/// Draws, judges and counts the solvers. Their numbers begin with `first`.
Totals measured(const Settings& settings, std::uint64_t first, std::uint64_t solvers) {
  constexpr std::uint64_t at_once = 10;  // bounds the memory, and shows progress
  Totals totals;
  while (totals.solvers < solvers) {
    std::vector<Planted> planted;
    std::vector<Subject> subjects;
    for (std::uint64_t i = totals.solvers; i < std::min(totals.solvers + at_once, solvers); ++i) {
      subjects.push_back(subject_of(planted.emplace_back(drawn_solver(settings, first + i))));
    }
    const GateReport report = judged(subjects, settings.cases);
    const std::vector<Diagnosis> found = properties::diagnosis::diagnose_all(report);
    for (std::size_t i = 0; i < planted.size(); ++i) {
      count(planted[i], report.results[i], found[i].faults, totals);
    }
    std::fflush(stdout);
  }
  return totals;
}

void print_totals(std::string_view title, const Totals& totals) {
  fmt::print(
      "{}: {}; violated: {}; the first fault is planted: {}; every defect is named: {}; with a false fault: {}\n",
      title, totals.solvers, totals.violated, totals.named_first, totals.named, totals.with_false);
}

/// Whether the solvers without a defect violate nothing.
bool are_sound(std::uint64_t cases) {
  std::vector<Subject> subjects;
  for (const Law law : drawn_laws) {
    subjects.push_back(subject_of({0, law, {}}));
  }
  bool are_all = true;
  for (const SubjectResult& result : judged(subjects, cases).results) {
    for (const properties::Invariant* invariant : result.violated_invariants()) {
      fmt::print("{} without a defect violates {}\n", result.subject.name, invariant->name);
      are_all = false;
    }
  }
  return are_all;
}

Settings settings_of(int argc, char** argv) {
  Settings settings;
  const std::map<std::string_view, std::uint64_t*> options{{"--seed", &settings.seed},
                                                           {"--cases", &settings.cases},
                                                           {"--singles", &settings.singles},
                                                           {"--pairs", &settings.pairs}};
  for (int i = 1; i < argc; i += 2) {
    const auto option = options.find(argv[i]);
    if (option == options.end() || i + 1 == argc) {
      throw std::invalid_argument(
          fmt::format("{}: expected --seed, --cases, --singles or --pairs, and a number", argv[i]));
    }
    *option->second = std::stoull(argv[i + 1]);
  }
  if (settings.cases == 0) {
    throw std::invalid_argument("--cases: expected a number greater than 0");
  }
  return settings;
}

int run(int argc, char** argv) {
  const Settings settings = settings_of(argc, argv);
  if (!are_sound(settings.cases)) {
    return 1;
  }
  const Totals singles = measured(settings, 1, settings.singles);
  const Totals pairs = measured(settings, settings.singles + 1, settings.pairs);
  print_totals("solvers with one defect", singles);
  print_totals("solvers with two defects", pairs);
  constexpr std::uint64_t most_false = 5;
  constexpr std::uint64_t least_named = 34;
  const bool is_complete = singles.solvers == complete_singles && pairs.solvers == complete_pairs;
  const bool is_missed = is_complete && (singles.with_false > most_false || pairs.named < least_named);
  return is_missed || singles.named + pairs.named == 0 ? 1 : 0;
}

}  // namespace
}  // namespace carom::mutants

int main(int argc, char** argv) {
  return carom::unit::exit_status("carom_drawn_defects", [&] { return carom::mutants::run(argc, argv); });
}
