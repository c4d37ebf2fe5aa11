// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <string>

#include <benchmark/benchmark.h>

#include "commands/chart.hpp"

namespace carom::tool::chart {
namespace {

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
