// SPDX-License-Identifier: BSL-1.0
// Measures judgements per second and core, in rational arithmetic alone and with filters. It also times the generation
// of cases, and the whole gate for each number of threads. It takes the flags of Google Benchmark. The last lines print
// the ratio of the two rates.
#include <algorithm>
#include <ctime>
#include <map>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>

#include "io/threads.hpp"
#include "support/exit_status.hpp"

namespace carom::benchmarks {
namespace {

using properties::Claim;
using properties::JudgedCase;
using properties::Trial;

constexpr std::uint64_t seed = 1;

std::vector<Subject> sound_subjects() {
  std::vector<Subject> sound = subjects::built_in_subjects();
  std::erase_if(sound, [](const Subject& subject) { return !subject.expected_to_pass; });
  return sound;
}

struct Asked {
  Answer answer;
  std::vector<Answer> related;
};

/// Cases with the answers of each subject, so that the benchmark times only the judge.
struct Prepared {
  std::vector<Subject> subjects;
  std::vector<properties::Case> cases;
  std::vector<std::vector<Asked>> asked;  // indexed by case and subject, in the order of judging
};

properties::RelationTurn relations_if(bool wanted) {
  return wanted ? properties::RelationTurn{} : properties::no_relations;
}

Prepared prepared(std::vector<Subject> subjects, const std::vector<Claim>& claims, const properties::Family& family,
                  std::uint64_t count, bool with_relations) {
  Prepared result{std::move(subjects), {}, {}};
  for (std::uint64_t i = 0; i < count; ++i) {
    result.cases.push_back(properties::drawn_case(family, seed, i));
  }
  std::vector<Session> sessions;
  for (const Subject& subject : result.subjects) {
    sessions.push_back(subject.open());
  }
  for (const properties::Case& one : result.cases) {
    const JudgedCase judged(one);
    std::vector<Asked>& all = result.asked.emplace_back();
    for (std::size_t s = 0; s < sessions.size(); ++s) {
      Asked asked{properties::answers_of(sessions[s], std::span(&one.collision, 1)).front(), {}};
      const Trial trial(judged, claims[s], properties::lift(asked.answer), relations_if(with_relations));
      if (trial.question_count() > 0) {
        asked.related = properties::answers_of(sessions[s], trial.questions());
      }
      all.push_back(std::move(asked));
    }
  }
  return result;
}

/// All subjects share the results computed for a case, as in the gate.
std::uint64_t judge_all(const Prepared& work, const std::vector<Claim>& claims, bool with_relations) {
  std::uint64_t verdicts = 0;
  std::vector<double> known(work.subjects.size(), 0);
  for (std::size_t i = 0; i < work.cases.size(); ++i) {
    const JudgedCase judged(work.cases[i]);
    for (std::size_t s = 0; s < work.subjects.size(); ++s) {
      const Asked& asked = work.asked[i][s];
      const Trial trial(judged, claims[s], properties::lift(asked.answer), relations_if(with_relations));
      const properties::Judgement judgement =
          trial.judge(std::span(asked.related).first(trial.question_count()), known[s]);
      verdicts += judgement.verdicts.size();
      if (judgement.accuracy && judgement.accuracy->is_decided) {
        known[s] = std::max(known[s], judgement.accuracy->backward_error(claims[s].yardstick.unit_roundoff()));
      }
    }
  }
  return verdicts;
}

std::vector<Claim> claims_of(const std::vector<Subject>& subjects, bool filtered) {
  std::vector<Claim> claims;
  for (const Subject& subject : subjects) {
    claims.push_back(properties::claim_of(subject, {.filtered = filtered}));
  }
  return claims;
}

std::map<std::string, double>& rates() {
  static std::map<std::string, double> all;
  return all;
}

void judge(benchmark::State& state, const std::string& name, const std::vector<Subject>& subjects, bool filtered,
           bool with_relations) {
  constexpr std::uint64_t cases = 8;  // for each family
  const std::vector<Claim> claims = claims_of(subjects, filtered);
  std::vector<Prepared> work;
  for (const properties::Family& family : properties::all_families()) {
    work.push_back(prepared(subjects, claims, family, cases, with_relations));
  }
  std::uint64_t judgements = 0;
  std::uint64_t verdicts = 0;
  const std::clock_t start = std::clock();  // processor time
  for ([[maybe_unused]] const auto _ : state) {
    for (const Prepared& one : work) {
      verdicts += judge_all(one, claims, with_relations);
      judgements += one.cases.size() * subjects.size();
    }
  }
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  rates()[name] = static_cast<double>(judgements) / seconds;
  state.counters["judgements/s"] = benchmark::Counter(static_cast<double>(judgements), benchmark::Counter::kIsRate);
  state.counters["verdicts/s"] = benchmark::Counter(static_cast<double>(verdicts), benchmark::Counter::kIsRate);
}

void generate(benchmark::State& state) {
  std::uint64_t made = 0;
  for ([[maybe_unused]] const auto _ : state) {
    for (const properties::Family& family : properties::all_families()) {
      benchmark::DoNotOptimize(properties::drawn_case(family, seed, made));
      ++made;
    }
  }
  state.counters["cases/s"] = benchmark::Counter(static_cast<double>(made), benchmark::Counter::kIsRate);
}

void whole_gate(benchmark::State& state, const std::vector<Subject>& subjects, unsigned jobs,
                std::uint64_t relations_every) {
  properties::GateOptions options;
  options.cases = 100;
  options.workers = tool::threads(jobs);
  options.relations_every = relations_every;
  options.families = properties::pointers_to(properties::all_families());
  std::uint64_t judgements = 0;
  for ([[maybe_unused]] const auto _ : state) {
    benchmark::DoNotOptimize(run_gate(subjects, options));
    judgements += options.cases * options.families.size() * subjects.size();
  }
  state.counters["judgements/s"] = benchmark::Counter(static_cast<double>(judgements), benchmark::Counter::kIsRate);
}

int run(int argc, char** argv) {
  const std::vector<Subject> sound = sound_subjects();
  const std::vector<Subject> alone{subjects::subject_named("reflection-double").value()};
  for (const bool with_relations : {false, true}) {
    for (const bool filtered : {false, true}) {
      for (const auto& [judged, subjects] : {std::pair("all", sound), std::pair("alone/reflection-double", alone)}) {
        const std::string name = fmt::format("{}/{}/{}", filtered ? "filtered" : "rational",
                                             with_relations ? "relations" : "one_outcome", judged);
        benchmark::RegisterBenchmark(("judge/" + name).c_str(), [=, subjects = subjects](benchmark::State& state) {
          judge(state, name, subjects, filtered, with_relations);
        })->Unit(benchmark::kMillisecond);
      }
    }
  }
  benchmark::RegisterBenchmark("generate", generate);
  for (const unsigned jobs : {1U, 2U, 4U}) {
    for (const std::uint64_t relations_every : {1U, 1000000U}) {
      benchmark::RegisterBenchmark(fmt::format("gate/jobs:{}/relations_every:{}", jobs, relations_every).c_str(),
                                   [=](benchmark::State& state) { whole_gate(state, sound, jobs, relations_every); })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  fmt::print("\nratio of the filtered judge to the rational one, same run\n");
  for (const auto& [name, rate] : rates()) {
    if (name.starts_with("filtered")) {
      const auto rational = rates().find("rational" + name.substr(8));
      if (rational != rates().end()) {
        fmt::print("{:<58}{:>12.0f}/s{:>10.1f}\n", name.substr(9), rate, rate / rational->second);
      }
    }
  }
  return 0;
}

}  // namespace
}  // namespace carom::benchmarks

int main(int argc, char** argv) {
  return carom::unit::exit_status("judge_rate", [&] { return carom::benchmarks::run(argc, argv); });
}
