// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <numeric>
#include <random>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>

#include "catalogue.hpp"
#include "io/threads.hpp"
#include "support/changed_subject.hpp"

/// The gate's diagnosis of planted defects, for every row of the table in docs/reference/diagnoses.md.
namespace carom::mutants {
namespace {

using properties::diagnosis::diagnose_all;
using properties::diagnosis::Diagnosis;
using properties::diagnosis::Fault;

/// A row of the page, "| `MUTANT`: SENTENCE | SAYS |".
struct KnownDefect {
  const Mutant* mutant;
  std::string says;  // parts of the diagnosis, separated by …; the diagnosis contains them in this order
};

/// The limits that diagnoses state, in the code of the defects.
constexpr std::pair<std::string_view, double> limits[]{
    {"restitution_threshold", 0.2},   {"mass_ratio_capped", 100},           {"heavy_as_immovable", 1e6},
    {"tiny_lever_arm_as_zero", 1e-6}, {"small_moments_as_infinite", 1e-32}, {"slow_approach_ignored", 1e-3},
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<KnownDefect> known_defects() {
  std::ifstream page(CAROM_DIAGNOSES_PAGE);
  std::vector<KnownDefect> rows;
  for (std::string line; std::getline(page, line);) {
    const std::size_t name_end = line.find("`: ");
    if (line.starts_with("| `") && name_end != std::string::npos) {
      const std::size_t bar = line.find('|', name_end);
      rows.push_back(
          {&mutant_named(line.substr(3, name_end - 3)), trimmed(line.substr(bar + 1, line.rfind('|') - bar - 1))});
    }
  }
  return rows;
}

std::string text_of(const Fault& fault) { return fault.what + ' ' + fault.where + " Look at: " + fault.look_at; }

/// The place in the text behind the parts of `says`; npos if the text does not contain all of them in order.
std::size_t place_behind(const std::string& says, const std::string& text) {
  std::size_t place = 0;
  for (const auto& part : std::views::split(says, std::string_view("…"))) {
    const std::string words = trimmed(std::string(part.begin(), part.end()));
    place = text.find(words, place);
    if (place == std::string::npos) {
      return place;
    }
    place += words.size();
  }
  return place;
}

/// Whether the text says what the row says, with a limit within 10 % of the planted one. The limit that the text states
/// depends on the sampled cases.
bool is_named_in(const std::string& text, const KnownDefect& defect) {
  constexpr double nearness = 0.1;
  const auto* limit = std::ranges::find(limits, defect.mutant->name, &std::pair<std::string_view, double>::first);
  if (limit == std::end(limits)) {
    return place_behind(defect.says, text) != std::string::npos;
  }
  const std::string before_limit = defect.says.substr(0, defect.says.find_last_not_of("0123456789.e+-") + 1);
  const std::size_t place = place_behind(before_limit, text);
  return place != std::string::npos &&
         std::abs(std::strtod(text.c_str() + place, nullptr) - limit->second) <= nearness * limit->second;
}

/// As many cases as the diagnosis examines. It examines one answer in five of a default run.
constexpr std::uint64_t enough = 200;

/// A run over all families, without shrinking. Relations are judged seldom, because a diagnosis rests on single
/// answers. Some defects remember the last collision, so one thread judges all cases in order.
properties::GateReport judged(const std::vector<Subject>& subjects, std::uint64_t cases) {
  properties::GateOptions options = unit::gate_options(cases);
  options.shrinks = false;
  options.relations_every = 50;
  properties::GateReport report = run_gate(subjects, options);
  report.options.workers = tool::threads(0);  // for the diagnosis
  return report;
}

/// Prints the diagnoses in full.
TEST(Diagnosis, SaysOfEachPlantedDefectWhatThePageSays) {
  const std::vector<KnownDefect> known = known_defects();
  ASSERT_GT(known.size(), 20U) << "the table of the page was not found";
  std::vector<Subject> subjects;
  for (const KnownDefect& row : known) {
    subjects.push_back(subject_of(*row.mutant));
  }
  const std::vector<Diagnosis> found = diagnose_all(judged(subjects, enough));
  for (std::size_t s = 0; s < known.size(); ++s) {
    const std::string_view name = known[s].mutant->name;
    ASSERT_FALSE(found[s].faults.empty()) << name;
    const std::string text = text_of(found[s].faults[0]);
    std::cout << name << ": " << text << '\n';
    EXPECT_EQ(found[s].faults.size(), 1U) << name << ", also: " << text_of(found[s].faults.back());
    EXPECT_NE(place_behind(known[s].says, text), std::string::npos) << name << ": " << text;
  }
}

using Together = std::vector<const KnownDefect*>;

std::string names_of(const Together& defects) {
  std::string names;
  for (const KnownDefect* defect : defects) {
    names.append(names.empty() ? "" : "+").append(defect->mutant->name);
  }
  return names;
}

/// A solver of `reflection` for each set of defects. Every known defect can be planted in a solver for this law.
std::vector<Subject> subjects_with(const std::vector<Together>& sets) {
  std::vector<Subject> subjects;
  for (const Together& defects : sets) {
    std::vector<std::string_view> planted;
    for (const KnownDefect* defect : defects) {
      planted.push_back(defect->mutant->defect);
    }
    subjects.push_back(make_subject(names_of(defects), Law::reflection, planted));
  }
  return subjects;
}

/// The known defects of which each alone violates at least a hundredth of the cases.
Together frequent_defects(const std::vector<KnownDefect>& known) {
  constexpr std::uint64_t few = 100;  // a share of 1 % is 55 violated cases
  constexpr double least_share = 0.01;
  std::vector<Together> alone;
  for (const KnownDefect& defect : known) {
    alone.push_back({&defect});
  }
  const properties::GateReport report = judged(subjects_with(alone), few);
  Together frequent;
  for (std::size_t s = 0; s < known.size(); ++s) {
    std::uint64_t violated = 0;
    std::uint64_t cases = 0;
    for (const properties::FamilyResult& family : report.results[s].families) {
      violated += family.violated;
      cases += family.judged();
    }
    if (static_cast<double>(violated) >= least_share * static_cast<double>(cases)) {
      frequent.push_back(&known[s]);
    }
  }
  return frequent;
}

/// `count` different sets of `size` of the defects.
std::vector<Together> drawn_sets(const Together& defects, std::size_t size, std::size_t count) {
  std::mt19937_64 random(1);
  std::vector<Together> sets;
  while (sets.size() < count) {
    std::vector<std::size_t> places(defects.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    for (std::size_t i = 0; i < size; ++i) {
      std::swap(places[i], places[i + random() % (places.size() - i)]);
    }
    places.resize(size);
    std::ranges::sort(places);
    Together set;
    for (const std::size_t place : places) {
      set.push_back(defects[place]);
    }
    if (std::ranges::find(sets, set) == sets.end()) {
      sets.push_back(std::move(set));
    }
  }
  return sets;
}

/// Whether the diagnosis names all of the defects. Adds to `others` what it says if it does not.
bool are_named(const Together& defects, const Diagnosis& found, std::string& others) {
  const auto is_named = [&](const KnownDefect* defect) {
    return std::ranges::any_of(found.faults, [&](const Fault& fault) { return is_named_in(text_of(fault), *defect); });
  };
  if (std::ranges::all_of(defects, is_named)) {
    return true;
  }
  others += names_of(defects) + ":\n";
  for (const Fault& fault : found.faults) {
    others += "  " + text_of(fault) + '\n';
  }
  return false;
}

/// Expects that the diagnosis names all defects of at least `least` among `count` sets of `size` defects. A defect may
/// be invisible, because another one overwrites its effect.
void expect_named_together(std::size_t size, std::size_t count, int least) {
  const std::vector<KnownDefect> known = known_defects();
  const Together frequent = frequent_defects(known);
  ASSERT_GE(frequent.size(), 30U);
  const std::vector<Together> sets = drawn_sets(frequent, size, count);
  const std::vector<Diagnosis> found = diagnose_all(judged(subjects_with(sets), properties::default_cases));
  int complete = 0;
  std::string others;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    complete += are_named(sets[s], found[s], others) ? 1 : 0;
  }
  EXPECT_GE(complete, least) << "of " << count << " sets of " << size << "; the others are\n" << others;
}

TEST(Diagnosis, NamesTwoDefectsThatArePlantedTogether) { expect_named_together(2, 30, 27); }

TEST(Diagnosis, NamesThreeDefectsThatArePlantedTogether) { expect_named_together(3, 10, 7); }

}  // namespace
}  // namespace carom::mutants
