// SPDX-License-Identifier: BSL-1.0
// Measures the diagnosis on defects that a seed draws: carom_drawn_defects [--seed S] [--cases N] [--singles N]
// [--pairs N] [--only N]
//
// Prints each solver with the faults that the gate names, then the totals. Solvers with one defect come first, then
// solvers with two. `--only` judges the solver with this number. Exit status 1: a sound solver is violated, no
// defect is named, or a complete run misses a goal.
#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>

#include "drawn_defects.hpp"
#include "io/threads.hpp"
#include "support/exit_status.hpp"

namespace carom::mutants {
namespace {

using properties::GateReport;
using properties::SubjectResult;
using properties::diagnosis::Diagnosis;
using properties::diagnosis::Fault;

constexpr std::uint64_t complete_singles = 100;
constexpr std::uint64_t complete_pairs = 40;
constexpr double least_share = 0.01;  // of the cases, that each defect of a pair spoils alone

struct Settings {
  std::uint64_t seed = 1;
  std::uint64_t cases = 60;
  std::uint64_t singles = complete_singles;
  std::uint64_t pairs = complete_pairs;
  std::uint64_t only = 0;  // 0 for all
};

struct Planted {
  std::uint64_t number;
  Law law;
  std::vector<DrawnDefect> defects;
};

Subject subject_of(Law law, const std::vector<DrawnDefect>& defects) {
  std::string name(name_of(law));
  std::vector<Change> changes;
  for (const DrawnDefect& defect : defects) {
    name.append("+").append(defect.kind);
    changes.push_back(defect.change);
  }
  return changed_solver(std::move(name), law, std::move(changes));
}

/// Judges relations seldom: a diagnosis rests on single answers.
GateReport judged(const std::vector<Subject>& subjects, std::uint64_t cases) {
  constexpr std::uint64_t seldom = 50;
  properties::GateOptions options;
  options.cases = cases;
  options.families = properties::pointers_to(properties::all_families());
  options.shrinks = false;
  options.relations_every = seldom;
  options.workers = tool::threads(2);
  return run_gate(subjects, options);
}

struct Share {
  std::uint64_t violated = 0;
  std::uint64_t judged = 0;

  [[nodiscard]] double value() const { return static_cast<double>(violated) / static_cast<double>(judged); }
};

Share violated_share(const SubjectResult& result) {
  Share share;
  for (const properties::FamilyResult& family : result.families) {
    share.violated += family.violated;
    share.judged += family.judged();
  }
  return share;
}

DrawnDefect drawn_for(Law law, Random& random) {
  std::vector<DefectKind> kinds = all_defect_kinds();
  std::erase_if(kinds, [&](const DefectKind& kind) { return std::ranges::find(kind.laws, law) == kind.laws.end(); });
  return drawn_defect(kinds[random.below(kinds.size())], random);
}

/// The random numbers of a solver. They do not depend on the number of solvers.
Random random_of(std::uint64_t seed, std::uint64_t number) {
  constexpr std::uint64_t most_solvers = 1'000'000;
  return Random(seed * most_solvers + number);
}

bool is_frequent(Law law, const DrawnDefect& defect) {
  constexpr std::uint64_t few = 10;
  return violated_share(judged({subject_of(law, {defect})}, few).results[0]).value() >= least_share;
}

DrawnDefect frequent_defect(Law law, Random& random) {
  for (;;) {
    DrawnDefect defect = drawn_for(law, random);
    if (is_frequent(law, defect)) {
      return defect;
    }
  }
}

Planted drawn_pair(std::uint64_t seed, std::uint64_t number) {
  Random random = random_of(seed, number);
  const Law law = drawn_laws[random.below(drawn_laws.size())];
  Planted planted{number, law, {frequent_defect(law, random)}};
  while (planted.defects.size() < 2) {
    DrawnDefect second = frequent_defect(law, random);
    const bool replace_both = second.change.impulse && planted.defects[0].change.impulse;
    const bool test_both = second.change.test && planted.defects[0].change.test;
    if (second.kind != planted.defects[0].kind && !replace_both && !test_both) {
      planted.defects.push_back(std::move(second));
    }
  }
  return planted;
}

std::vector<Planted> drawn_solvers(const Settings& settings) {
  std::vector<Planted> drawn;
  const auto is_asked = [&](std::uint64_t number) { return settings.only == 0 || settings.only == number; };
  for (std::uint64_t n = 1; n <= settings.singles; ++n) {
    if (is_asked(n)) {
      Random random = random_of(settings.seed, n);
      const Law law = drawn_laws[random.below(drawn_laws.size())];
      drawn.push_back({n, law, {drawn_for(law, random)}});
    }
  }
  for (std::uint64_t n = settings.singles + 1; n <= settings.singles + settings.pairs; ++n) {
    if (is_asked(n)) {
      const bool is_given = n == settings.singles + 1;
      drawn.push_back(is_given ? Planted{n, Law::frictionless, threshold_and_world_axes()}
                               : drawn_pair(settings.seed, n));
    }
  }
  return drawn;
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
void count(const Planted& planted, const SubjectResult& result, const Diagnosis& diagnosis, Totals& totals) {
  const auto is_true = [&](const Fault& fault) {
    return std::ranges::any_of(planted.defects, [&](const DrawnDefect& defect) { return describes(fault, defect); });
  };
  const auto is_named_by = [&](const Fault& fault) {
    return std::ranges::any_of(planted.defects, [&](const DrawnDefect& defect) { return names(fault, defect); });
  };
  const auto is_named = [&](const DrawnDefect& defect) {
    return std::ranges::any_of(diagnosis.faults, [&](const Fault& fault) { return names(fault, defect); });
  };
  const std::vector<Fault>& faults = diagnosis.faults;
  const Share share = violated_share(result);
  const bool named_first = !faults.empty() && is_named_by(faults[0]);
  const bool all_named = std::ranges::all_of(planted.defects, is_named);
  const bool has_false = faults.size() > 1 && !std::ranges::all_of(faults, is_true);
  ++totals.solvers;
  totals.violated += share.violated > 0 ? 1 : 0;
  totals.named_first += named_first ? 1 : 0;
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

void print_totals(std::string_view title, const Totals& totals) {
  fmt::print(
      "{}: {}; violated: {}; the first fault is planted: {}; every defect is named: {}; with a false fault: {}\n",
      title, totals.solvers, totals.violated, totals.named_first, totals.named, totals.with_false);
}

/// Precondition: `drawn` is in the order of the numbers.
std::array<Totals, 2> measured(const std::vector<Planted>& drawn, const Settings& settings) {
  constexpr std::size_t at_once = 10;  // bounds the memory, and shows progress
  std::array<Totals, 2> totals;
  for (std::size_t from = 0; from < drawn.size(); from += at_once) {
    const std::size_t to = std::min(from + at_once, drawn.size());
    std::vector<Subject> subjects;
    for (std::size_t i = from; i < to; ++i) {
      subjects.push_back(subject_of(drawn[i].law, drawn[i].defects));
    }
    const GateReport report = judged(subjects, settings.cases);
    const std::vector<Diagnosis> found = properties::diagnosis::diagnose_all(report);
    for (std::size_t i = from; i < to; ++i) {
      count(drawn[i], report.results[i - from], found[i - from], totals[drawn[i].defects.size() - 1]);
    }
    std::fflush(stdout);
  }
  return totals;
}

/// Whether the solvers without a defect violate nothing.
bool are_sound(std::uint64_t cases) {
  std::vector<Subject> subjects;
  for (const Law law : drawn_laws) {
    subjects.push_back(subject_of(law, {}));
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
  const std::pair<std::string_view, std::uint64_t*> options[]{{"--seed", &settings.seed},
                                                              {"--cases", &settings.cases},
                                                              {"--singles", &settings.singles},
                                                              {"--pairs", &settings.pairs},
                                                              {"--only", &settings.only}};
  for (int i = 1; i < argc; i += 2) {
    const auto* option =
        std::ranges::find(options, std::string_view(argv[i]), &std::pair<std::string_view, std::uint64_t*>::first);
    if (option == std::end(options) || i + 1 == argc) {
      throw std::invalid_argument(
          fmt::format("{}: expected --seed, --cases, --singles, --pairs or --only, and a number", argv[i]));
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
  if (settings.only == 0 && !are_sound(settings.cases)) {
    return 1;
  }
  const auto [singles, pairs] = measured(drawn_solvers(settings), settings);
  print_totals("solvers with one defect", singles);
  print_totals("solvers with two defects", pairs);
  const bool is_complete = singles.solvers == complete_singles && pairs.solvers == complete_pairs;
  constexpr std::uint64_t most_false = 5;
  constexpr std::uint64_t least_named = 34;
  const bool is_missed = is_complete && (singles.with_false > most_false || pairs.named < least_named);
  return is_missed || singles.named + pairs.named == 0 ? 1 : 0;
}

}  // namespace
}  // namespace carom::mutants

int main(int argc, char** argv) {
  return carom::unit::exit_status("carom_drawn_defects", [&] { return carom::mutants::run(argc, argv); });
}
