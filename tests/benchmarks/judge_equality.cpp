// SPDX-License-Identifier: BSL-1.0
// Judges each outcome twice, with all filters and in rational arithmetic alone. Counts the equal verdicts:
//
//  judge_equality [--cases N] [--seed S] [--jobs J] [--relations-every R] [--wild-every W] [--long-every L]
//  [--one-subject] [--laws L,L]
//
// One case in W (default 3) is wild: its numbers have extreme sizes. Families draw the rest. Of these cases, one in L
// (default 1) keeps all digits. The others are shortened, because the rational judge is faster on few digits. Each case
// goes to all subjects, or with --one-subject to a random subject. Subjects are built-in solvers, mutants, and made-up
// outcomes at the edge of the permitted rounding. The judges judge relations on one case in R. With --laws, only
// subjects of these laws run. The exit status is 1 if a verdict differs.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <carom/subjects/catalogue.hpp>

#include "agreement.hpp"
#include "mutants/catalogue.hpp"
#include "planted.hpp"
#include "support/exit_status.hpp"
#include "wild.hpp"

namespace carom::benchmarks {
namespace {

using equality::Agreement;
using equality::Examined;
using equality::Relations;

std::vector<Subject> subjects_and_mutants() {
  std::vector<Subject> subjects = subjects::all_subjects();
  for (const mutants::Mutant& mutant : mutants::all_mutants()) {
    subjects.push_back(mutants::subject_of(mutant));
  }
  for (const Law law : all_laws) {
    for (const Precision precision : {Precision::binary32, Precision::binary64, Precision::extended}) {
      if (law != Law::any) {
        subjects.push_back(equality::planting_subject(law, precision));
      }
    }
  }
  return subjects;
}

std::vector<Examined> examined_of(const std::vector<std::string>& laws) {
  std::vector<Examined> examined;
  for (const Subject& subject : subjects_and_mutants()) {
    const bool is_asked_for = laws.empty() || std::find(laws.begin(), laws.end(), name_of(subject.law)) != laws.end();
    if (subject.absent.empty() && is_asked_for) {
      examined.emplace_back(subject);
    }
  }
  return examined;
}

struct Options {
  std::uint64_t cases = 10000;
  std::uint64_t seed = 1;
  unsigned jobs = 1;
  int relations_every = 10;
  int wild_every = 3;
  int long_every = 1;
  bool one_subject = false;
  std::vector<std::string> laws;
};

struct Drawn {
  properties::Case one;
  std::string name;
};

Drawn drawn_case(const Options& options, std::uint64_t i, properties::Stream& choices) {
  properties::Stream stream = properties::case_stream(options.seed, "judge_equality", i);
  if (choices.chance(options.wild_every)) {
    return {equality::wild_case(stream), fmt::format("case {} (wild)", i)};
  }
  const auto families = properties::all_families();
  const properties::Family& family = families[stream.bits() % families.size()];
  properties::Case one = family.generate(stream);
  if (choices.chance(options.long_every)) {
    return {one, fmt::format("case {} ({})", i, family.name)};
  }
  return {equality::shortened(one, stream), fmt::format("case {} ({}, shortened)", i, family.name)};
}

void compare(const Options& options, std::atomic<std::uint64_t>& next, Agreement& agreement) {
  std::vector<Examined> subjects = examined_of(options.laws);
  for (std::uint64_t i = next++; i < options.cases; i = next++) {
    properties::Stream choices = properties::case_stream(options.seed, "choices of judge_equality", i);
    const Drawn drawn = drawn_case(options, i, choices);
    const Relations relations = choices.chance(options.relations_every) ? Relations::judged : Relations::left_out;
    const auto examined =
        options.one_subject ? std::span(subjects).subspan(choices.bits() % subjects.size(), 1) : std::span(subjects);
    equality::compare_judges(drawn.one, examined, relations, drawn.name, agreement);
  }
}

double rate(std::uint64_t count, std::chrono::nanoseconds spent) {
  return static_cast<double>(count) / std::chrono::duration<double>(spent).count();
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Compares the filtered judge with the rational one");
  app.add_option("--cases", options.cases);
  app.add_option("--seed", options.seed);
  app.add_option("--jobs", options.jobs)->check(CLI::PositiveNumber);
  app.add_option("--relations-every", options.relations_every)->check(CLI::PositiveNumber);
  app.add_option("--wild-every", options.wild_every)->check(CLI::PositiveNumber);
  app.add_option("--long-every", options.long_every)->check(CLI::PositiveNumber);
  app.add_flag("--one-subject", options.one_subject);
  std::vector<std::string> laws;
  for (const Law law : all_laws) {
    laws.emplace_back(name_of(law));
  }
  app.add_option("--laws", options.laws)->delimiter(',')->check(CLI::IsMember(laws));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  std::atomic<std::uint64_t> next = 0;
  std::vector<Agreement> agreements(options.jobs);
  {
    // With --jobs 1 no thread starts, so the reference counts of rationals need not be atomic.
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i + 1 < agreements.size(); ++i) {
      workers.emplace_back([&, i] { compare(options, next, agreements[i]); });
    }
    compare(options, next, agreements.back());
  }
  Agreement all;
  for (const Agreement& agreement : agreements) {
    all += agreement;
  }
  fmt::print("{:<24}{:>12}{:>12}{:>12}\n", "invariant, exactly", "holds", "violated", "skipped");
  for (const auto& [name, count] : all.invariants) {
    fmt::print("{:<24}{:>12}{:>12}{:>12}\n", name, count.holds, count.violated, count.skipped);
  }
  fmt::print("{} cases, {} outcomes, {} verdicts, {} different\n", all.cases, all.judgements, all.verdicts,
             all.differences.size());
  fmt::print("rational {:.0f}, filtered {:.0f} judgements a second and thread: ratio {:.1f}\n",
             rate(all.judgements, all.rational), rate(all.judgements, all.filtered),
             rate(all.judgements, all.filtered) / rate(all.judgements, all.rational));
  for (std::size_t i = 0; i < all.differences.size() && i < 50; ++i) {
    fmt::print("{}\n", all.differences[i]);
  }
  return all.differences.empty() ? 0 : 1;
}

}  // namespace
}  // namespace carom::benchmarks

int main(int argc, char** argv) {
  return carom::unit::exit_status("judge_equality", [&] { return carom::benchmarks::run(argc, argv); });
}
