// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/trial.hpp>

#include "commands/chart.hpp"

namespace carom::tool::chart {
namespace {

/// At most this many cases are drawn for each wanted case.
constexpr std::size_t cases_drawn_for_each = 20;

template <class Generate>
std::vector<Collision> colliding(const Generate& generate, std::size_t count) {
  std::vector<Collision> found;
  for (std::size_t index = 0; found.size() < count && index < cases_drawn_for_each * count; ++index) {
    Collision collision = generate(index);
    if (validate(collision).empty() && oracles::ExactCase(collision).state() == oracles::ContactState::colliding) {
      found.push_back(std::move(collision));
    }
  }
  return found;
}

/// The accuracy of an answer to a colliding contact. The claim has no invariants.
void add_result(report::ExactnessBuilder& builder, const properties::JudgedCase& judged, const properties::Claim& claim,
                const Answer& answer) {
  const properties::Judgement judgement = judge_answer(judged, claim, properties::lift(answer));
  if (judgement.skipped || judgement.unjudged || judged.exact().state() != oracles::ContactState::colliding) {
    return;
  }
  const std::optional<oracles::Accuracy>& accuracy = judgement.accuracy;
  if (accuracy && accuracy->is_decided) {
    builder.add(accuracy->backward_error(claim.yardstick.unit_roundoff()), accuracy->digits(), accuracy->is_allowed());
  } else if (!accuracy || !judged.exact().is_open(claim.law, claim.yardstick.allowance())) {
    builder.add(std::numeric_limits<double>::infinity(), 0, false);  // an undecided outcome counts as a failure
  }
}

struct CoulombCase {
  CoulombCase(const Collision& collision, AnswersOfCoulomb asked)
      : judged({collision, false}),
        answers(asked == AnswersOfCoulomb::found ? oracles::coulomb_answers(judged.exact())
                                                 : std::vector<oracles::CoulombAnswer>()) {}

  properties::JudgedCase judged;
  std::vector<oracles::CoulombAnswer> answers;  // empty if they were left out

  void add_to(report::ExactnessBuilder& builder, double digits, bool holds) const {
    if (answers.empty()) {
      builder.add(holds);
    } else {
      builder.add(digits, holds);
    }
  }
};

void add_coulomb_result(report::ExactnessBuilder& builder, const CoulombCase& one, const properties::Claim& claim,
                        const Answer& answer) {
  const properties::Judgement judgement = judge_answer(one.judged, claim, properties::lift(answer));
  if (judgement.unjudged) {
    return;
  }
  const auto* const outcome = std::get_if<ReportedOutcome>(&answer);
  if (outcome == nullptr || !oracles::is_finite(*outcome)) {
    one.add_to(builder, 0, false);
    return;
  }
  const bool is_violated = std::any_of(
      judgement.verdicts.begin(), judgement.verdicts.end(),
      [](const properties::NamedVerdict& named) { return named.verdict.status == properties::Status::violated; });
  one.add_to(builder, oracles::nearest_answer(one.judged.exact(), one.answers, *outcome).digits, !is_violated);
}

/// The minimum duration of each repetition [s].
constexpr double repetition_time = 0.005;

/// Exactly contacts_in_kernel collisions, some of them repeatedly if there are fewer.
std::vector<Collision> filled(std::span<const Collision> collisions) {
  std::vector<Collision> result;
  for (std::size_t i = 0; i < contacts_in_kernel; ++i) {
    result.push_back(collisions[i % collisions.size()]);
  }
  return result;
}

/// Keeps the time of each repetition. The benchmark of a kernel has the kernel's index as its name.
class Times : public benchmark::BenchmarkReporter {
 public:
  Times(std::size_t kernels, int repetitions, const std::function<void(std::uint64_t, std::uint64_t)>& progress)
      : nanoseconds_(kernels), all_(kernels * static_cast<std::size_t>(repetitions)), progress_(progress) {}

  bool ReportContext(const Context& /*context*/) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration) {
        nanoseconds_[std::stoul(run.run_name.function_name)].push_back(run.GetAdjustedRealTime() /
                                                                       static_cast<double>(contacts_in_kernel));
        ++done_;
      }
    }
    if (progress_) {
      progress_(done_, all_);
    }
  }

  [[nodiscard]] std::vector<report::Spread> spreads() const {
    std::vector<report::Spread> result;
    for (std::vector<double> times : nanoseconds_) {
      std::sort(times.begin(), times.end());
      result.push_back({report::quantile(times, 0.5), times.front(), times.back()});
    }
    return result;
  }

 private:
  std::vector<std::vector<double>> nanoseconds_;
  std::uint64_t done_ = 0;
  std::uint64_t all_;
  const std::function<void(std::uint64_t, std::uint64_t)>& progress_;
};

void set_up_benchmark() {
  // The library takes these settings only from a command line.
  std::array<std::string, 2> words{"carom", "--benchmark_enable_random_interleaving=true"};
  std::array<char*, 3> pointers{words[0].data(), words[1].data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, pointers.data());
}

}  // namespace

ChartedSubjects::ChartedSubjects(std::vector<Subject> subjects, std::stop_token stop)
    : subjects_(std::move(subjects)), are_over_(subjects_.size()) {
  constexpr unsigned most_failures = 100;
  for (const Subject& subject : subjects_) {
    properties::Restarts& restarts = restarts_.emplace_back(most_failures, std::chrono::minutes(1));
    sessions_.push_back(properties::open_restarting(subject, restarts, stop));
  }
}

std::vector<std::vector<Answer>> ChartedSubjects::answers_to(std::span<const Collision> collisions) {
  constexpr std::size_t most_at_once = 50;  // as the gate asks
  std::vector<std::vector<Answer>> answers(sessions_.size());
  for (std::size_t s = 0; s < sessions_.size(); ++s) {
    try {
      for (std::size_t first = 0; first < collisions.size() && !are_over_[s]; first += most_at_once) {
        const auto asked = collisions.subspan(first, std::min(most_at_once, collisions.size() - first));
        std::ranges::move(properties::answers_of(sessions_[s], asked), std::back_inserter(answers[s]));
      }
    } catch (const SessionFailure& failure) {
      std::ranges::copy(failure.answered(), std::back_inserter(answers[s]));
      are_over_[s] = true;
      failure_ = subjects_[s].name + ": " + failure.what();
    }
    answers[s].resize(collisions.size(), Skipped{});
  }
  return answers;
}

void ChartedSubjects::close() {
  for (std::size_t s = 0; s < sessions_.size(); ++s) {
    if (!are_over_[s]) {
      sessions_[s].close();
    }
  }
}

std::vector<Collision> colliding_cases(const properties::Family& family, std::uint64_t seed, std::size_t count) {
  return colliding([&](std::size_t index) { return properties::drawn_case(family, seed, index).collision; }, count);
}

std::vector<Collision> colliding_cases(const properties::Sweep& sweep, double quantity, std::uint64_t seed,
                                       std::size_t count) {
  const std::string name = fmt::format("{} {}", sweep.name, quantity);
  return colliding(
      [&](std::size_t index) {
        properties::Stream stream = properties::case_stream(seed, name, index);
        return sweep.generate(stream, quantity);
      },
      count);
}

std::vector<report::Exactness> measured_exactness(ChartedSubjects& charted, std::span<const Collision> collisions,
                                                  double limit_ulps, const properties::Workers& workers,
                                                  AnswersOfCoulomb answers_of_coulomb) {
  const std::span<const Subject> subjects = charted.subjects();
  const std::vector<std::vector<Answer>> answers = charted.answers_to(collisions);
  std::vector<properties::Claim> claims;
  for (const Subject& subject : subjects) {
    claims.push_back(properties::claim_of(subject, {limit_ulps}));
    if (subject.law != Law::coulomb) {
      claims.back().invariants.clear();  // the chart shows the accuracy alone
    }
  }
  // The cases are the outer loop, so that the truth of a case is computed once.
  std::vector<std::vector<report::ExactnessBuilder>> parts(std::max(1U, workers.count),
                                                           std::vector<report::ExactnessBuilder>(subjects.size()));
  std::atomic<std::size_t> next = 0;
  workers.run(parts.size(), [&](std::size_t worker) {
    std::vector<report::ExactnessBuilder>& part = parts[worker];
    for (std::size_t i = next++; i < collisions.size(); i = next++) {
      const properties::JudgedCase without_effects(properties::Case{collisions[i], false});
      std::optional<CoulombCase> coulomb_case;
      for (std::size_t s = 0; s < subjects.size(); ++s) {
        if (subjects[s].law == Law::coulomb) {
          if (!coulomb_case) {
            coulomb_case.emplace(collisions[i], answers_of_coulomb);
          }
          add_coulomb_result(part[s], *coulomb_case, claims[s], answers[s][i]);
        } else if (claims[s].effects == DeclaredEffects{}) {
          add_result(part[s], without_effects, claims[s], answers[s][i]);
        } else {
          add_result(part[s], properties::JudgedCase({collisions[i], false}, true, claims[s].effects), claims[s],
                     answers[s][i]);
        }
      }
    }
  });
  std::vector<report::Exactness> result;
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    for (std::size_t part = 1; part < parts.size(); ++part) {
      parts[0][s] += parts[part][s];
    }
    result.push_back(parts[0][s].built());
    result.back().has_backward_error = determines_outcome(subjects[s].law);
  }
  return result;
}

std::vector<report::Spread> measured_times(std::span<const TimedKernel> kernels, int repetitions,
                                           const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  set_up_benchmark();
  benchmark::ClearRegisteredBenchmarks();
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    const subjects::Kernel kernel = kernels[k].method->prepare(filled(kernels[k].collisions));
    benchmark::RegisterBenchmark(std::to_string(k).c_str(),
                                 [kernel](benchmark::State& state) {
                                   for (auto _ : state) {
                                     kernel();
                                     benchmark::ClobberMemory();
                                   }
                                 })
        ->MinTime(repetition_time)
        ->Repetitions(repetitions);
  }
  Times times(kernels.size(), repetitions, progress);
  benchmark::RunSpecifiedBenchmarks(&times);
  benchmark::ClearRegisteredBenchmarks();
  return times.spreads();
}

}  // namespace carom::tool::chart
