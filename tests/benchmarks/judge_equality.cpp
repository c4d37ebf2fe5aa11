// SPDX-License-Identifier: GPL-3.0-or-later
// Judges the same outcomes with every filter and in rational numbers alone, and counts the verdicts that agree:
// judge_equality [--cases N] [--seed S] [--jobs J] [--relations-every R] [--wild-every W] [--long-every L] [--subjects
// K] N cases of the families, one in W wild (three by default); each is put to all subjects, or to K in a row, drawn:
// the built-in ones, the mutants, and outcomes planted at the edge of what is allowed. Of the others one in L keeps all
// its digits (each by default); numbers of few digits cost the rational judge less. Relations are judged on every R-th
// case. Ends in 1 where anything differs.
#include <atomic>
#include <iostream>
#include <mutex>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <carom/subjects/catalogue.hpp>

#include "agreement.hpp"
#include "mutants/catalogue.hpp"
#include "planted.hpp"
#include "wild.hpp"

namespace {

using namespace carom;
using equality::Agreement;
using equality::Examined;
using equality::Relations;

std::vector<Examined> all_examined() {
  std::vector<Examined> subjects;
  for (const Subject& subject : subjects::all_subjects()) {
    if (subject.absent.empty()) {
      subjects.emplace_back(subject);
    }
  }
  for (const mutants::Mutant& mutant : mutants::all_mutants()) {
    subjects.emplace_back(mutants::subject_of(mutant));
  }
  for (const Model model : models_with_truth) {
    for (const Precision precision : {Precision::binary32, Precision::binary64, Precision::extended}) {
      subjects.emplace_back(equality::planting_subject(model, precision));
    }
  }
  return subjects;
}

struct Options {
  std::uint64_t cases = 10000;
  std::uint64_t seed = 1;
  unsigned jobs = 1;
  std::uint64_t relations_every = 10;
  std::uint64_t wild_every = 3;
  std::uint64_t long_every = 1;
  std::size_t subjects = 0;  // 0: all
};

/// The case, and what it is called in a difference.
struct Drawn {
  properties::Case one;
  std::string name;
};

Drawn drawn_case(const Options& options, std::uint64_t i, properties::Stream& stream) {
  if (i % options.wild_every == options.wild_every - 1) {
    return {equality::wild_case(stream), fmt::format("case {} (wild)", i)};
  }
  const auto families = properties::all_families();
  const properties::Family& family = families[stream.bits() % families.size()];
  properties::Case one = family.generate(stream);
  const bool is_long = i % options.long_every == 0;
  return {is_long ? one : equality::shortened(one, stream),
          fmt::format("case {} ({}{})", i, family.name, is_long ? "" : ", shortened")};
}

void compare(const Options& options, std::atomic<std::uint64_t>& next, Agreement& agreement) {
  std::vector<Examined> subjects = all_examined();
  for (std::uint64_t i = next++; i < options.cases; i = next++) {
    properties::Stream stream = properties::case_stream(options.seed, "judge_equality", i);
    const Drawn drawn = drawn_case(options, i, stream);
    const std::size_t count = options.subjects == 0 ? subjects.size() : options.subjects;
    const std::size_t first = stream.bits() % (subjects.size() - count + 1);
    equality::compare_judges(drawn.one, std::span(subjects).subspan(first, count),
                             i % options.relations_every == 0 ? Relations::judged : Relations::left_out, drawn.name,
                             agreement);
  }
}

double rate(std::uint64_t count, std::chrono::nanoseconds spent) {
  return static_cast<double>(count) / std::chrono::duration<double>(spent).count();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Compares the filtered judge with the rational one");
  app.add_option("--cases", options.cases);
  app.add_option("--seed", options.seed);
  app.add_option("--jobs", options.jobs)->check(CLI::PositiveNumber);
  app.add_option("--relations-every", options.relations_every)->check(CLI::PositiveNumber);
  app.add_option("--wild-every", options.wild_every)->check(CLI::PositiveNumber);
  app.add_option("--long-every", options.long_every)->check(CLI::PositiveNumber);
  app.add_option("--subjects", options.subjects)->check(CLI::Range(std::size_t{0}, all_examined().size()));
  CLI11_PARSE(app, argc, argv);
  std::atomic<std::uint64_t> next = 0;
  std::vector<Agreement> agreements(options.jobs);
  {
    // The last one works here: alone, it spares the rationals' shared digits their atomic counts.
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
