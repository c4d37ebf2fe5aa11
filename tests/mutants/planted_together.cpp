// SPDX-License-Identifier: BSL-1.0
#include "planted_together.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <sstream>
#include <utility>

#include <carom/properties/gate/gate.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/results/run.hpp>

#include "io/threads.hpp"
#include "mutable_solver.hpp"

namespace carom::mutants {
namespace {

properties::GateReport judged(const std::vector<Subject>& subjects, std::uint64_t cases) {
  properties::GateOptions options;
  options.cases = cases;
  options.shrinks = false;
  // A diagnosis rests on single answers. Relations only cost time.
  constexpr std::uint64_t rarely = 50;
  options.relations_every = rarely;
  // Some defects remember the last collision, so one thread judges all cases in order.
  options.workers = {};
  for (const properties::Family& family : properties::all_families()) {
    options.families.push_back(&family);
  }
  properties::GateReport report = run_gate(subjects, options);
  report.options.workers = tool::threads(0);  // for the diagnosis
  return report;
}

Subject subject_with(const Together& defects) {
  std::vector<Defect> planted;
  for (const KnownDefect* defect : defects) {
    planted.push_back(defect->mutant->defect);
  }
  return make_subject(names_of(defects), law_of_planted, planted);
}

double share_of_violated(const properties::SubjectResult& result) {
  double violated = 0;
  double judged = 0;
  for (const properties::FamilyResult& family : result.families) {
    violated += static_cast<double>(family.violated);
    judged += static_cast<double>(family.judged());
  }
  return violated / judged;
}

std::string first_lines(const std::string& text) {
  constexpr int most = 60;
  std::istringstream from(text);
  std::string lines;
  std::string line;
  for (int i = 0; i < most && std::getline(from, line); ++i) {
    lines += line + '\n';
  }
  return lines;
}

/// The parts of a report that describe one fault each, every part in one line.
std::vector<std::string> faults_in(std::string lines) {
  std::ranges::replace(lines, '\n', ' ');
  std::vector<std::string> faults;
  const std::string mark = "what is wrong";
  for (std::size_t begin = lines.find(mark); begin != std::string::npos;) {
    const std::size_t end = lines.find(mark, begin + 1);
    faults.push_back(lines.substr(begin, end - begin));
    begin = end;
  }
  return faults;
}

}  // namespace

std::vector<const KnownDefect*> frequent_defects(std::span<const KnownDefect> known) {
  std::vector<Subject> subjects;
  for (const KnownDefect& defect : known) {
    subjects.push_back(subject_with({&defect}));
  }
  constexpr std::uint64_t few = 100;  // a share of 1 % is 55 violated cases
  const properties::GateReport report = judged(subjects, few);
  std::vector<const KnownDefect*> frequent;
  for (std::size_t s = 0; s < known.size(); ++s) {
    constexpr double least_share = 0.01;
    if (share_of_violated(report.results[s]) >= least_share) {
      frequent.push_back(&known[s]);
    }
  }
  return frequent;
}

std::vector<Together> drawn_together(std::span<const KnownDefect* const> defects, std::size_t size, std::size_t count,
                                     std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Together> all;
  while (all.size() < count) {
    std::vector<std::size_t> places(defects.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    for (std::size_t i = 0; i < size; ++i) {
      std::swap(places[i], places[i + random() % (places.size() - i)]);
    }
    places.resize(size);
    std::ranges::sort(places);
    Together one;
    for (const std::size_t place : places) {
      one.push_back(defects[place]);
    }
    if (std::ranges::find(all, one) == all.end()) {
      all.push_back(std::move(one));
    }
  }
  return all;
}

std::vector<Told> told_of(std::span<const Together> all) {
  std::vector<Subject> subjects;
  for (const Together& one : all) {
    subjects.push_back(subject_with(one));
  }
  const report::Run run = report::diagnosed(
      {judged(subjects, properties::GateOptions().cases), {}, {}, {}, std::vector<bool>(subjects.size(), true), {}});
  std::vector<Told> told;
  for (std::size_t s = 0; s < all.size(); ++s) {
    report::Run alone = run;
    alone.results = {run.results[s]};
    alone.diagnoses = {run.diagnoses[s]};
    alone.counts = {true};
    Told& of_this = told.emplace_back(Told{all[s], {}, first_lines(run_text(alone, ""))});
    const std::vector<std::string> faults = faults_in(of_this.lines);
    for (const KnownDefect* defect : all[s]) {
      if (std::ranges::any_of(faults, [&](const std::string& fault) { return is_named_in(fault, *defect); })) {
        of_this.named.push_back(defect);
      }
    }
  }
  return told;
}

std::string names_of(const Together& defects) {
  std::string names;
  for (const KnownDefect* defect : defects) {
    names += (names.empty() ? "" : "+") + std::string(defect->mutant->name);
  }
  return names;
}

}  // namespace carom::mutants
