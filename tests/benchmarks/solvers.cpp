// SPDX-License-Identifier: BSL-1.0
// Times the solvers: solvers [--benchmark_…]. Prints medians, and their ratios to a baseline of the same run. A run
// takes about a minute.
#include <algorithm>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <carom/impulse/batch/solve.hpp>
#include <carom/impulse/laws.hpp>
#include <carom/subjects/methods.hpp>

#include "counted.hpp"
#include "measurements.hpp"
#include "peak.hpp"
#include "plain_note.hpp"
#include "support/exit_status.hpp"
#include "workload.hpp"

namespace carom::benchmarks {
namespace {

using impulse::InstructionSet;

constexpr const char* baseline_method = "reflection-llt-double";
constexpr std::size_t sizes[]{1, 2, 4, 8, 16, 64, 256, 1'000, 10'000, 100'000, out_of_cache};

const std::vector<subjects::Method>& methods() {
  static const std::vector<subjects::Method> all = subjects::methods();
  return all;
}

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> available;
  std::ranges::copy_if(impulse::all_instruction_sets, std::back_inserter(available), impulse::is_available);
  return available;
}

std::vector<unsigned> thread_counts() {
  std::vector<unsigned> counts;
  for (unsigned count = 1; count <= std::max(1U, std::thread::hardware_concurrency()); count *= 2) {
    counts.push_back(count);
  }
  return counts;
}

std::string batch_name(const std::string& scalar, Law law, std::size_t size, InstructionSet set) {
  return fmt::format("batch/{}/{}/{}/{}", name_of(law), scalar, size, name_of(set));
}
std::string slender_name(Law law) { return fmt::format("slender/{}", name_of(law)); }
std::string spheres_name(Law law) { return fmt::format("spheres/{}", name_of(law)); }
std::string tips_name(Law law) { return fmt::format("tips/{}", name_of(law)); }
std::string triad_name(std::size_t size) { return fmt::format("triad/{}", size); }
std::string threads_name(Law law, std::size_t size, unsigned threads) {
  return fmt::format("threads/{}/{}/{}", name_of(law), size, threads);
}
std::string plain_name(Law law) { return fmt::format("plain/{}", name_of(law)); }
std::string peak_name(InstructionSet set) { return fmt::format("peak/{}", name_of(set)); }

constexpr Law laws[]{Law::frictionless, Law::reflection};
constexpr Law batch_laws[]{Law::frictionless, Law::reflection, Law::rough};

template <class S>
Workload<S>& shared_workload(std::size_t size) {
  static std::map<std::size_t, Workload<S>> workloads;
  return workloads.try_emplace(size, size).first->second;
}

template <class S>
void register_batch(const std::string& scalar, Law law, std::size_t size, InstructionSet set) {
  benchmark::RegisterBenchmark(batch_name(scalar, law, size, set).c_str(), [=](benchmark::State& state) {
    Workload<S>& workload = shared_workload<S>(size);
    for (auto _ : state) {
      impulse::solve(workload.contacts, law, workload.outcomes, set);
      benchmark::ClobberMemory();
    }
  });
}

void register_methods() {
  static const std::vector<Collision> collisions = colliding(in_cache);
  for (const subjects::Method& method : methods()) {
    benchmark::RegisterBenchmark(method.subject.name.c_str(), [&method](benchmark::State& state) {
      const subjects::Kernel kernel = method.prepare(collisions);
      for (auto _ : state) {
        kernel();
        benchmark::ClobberMemory();
      }
    });
  }
}

void register_plain() {
  static const std::vector<Collision> collisions = colliding(in_cache);
  static const std::vector<plain::RigidBody> bodies = [] {
    std::vector<plain::RigidBody> all;
    for (const Collision& collision : collisions) {
      all.push_back(plain::rigid_body(collision.a));
      all.push_back(plain::rigid_body(collision.b));
    }
    return all;
  }();
  static const std::vector<plain::Contact> contacts = [] {
    std::vector<plain::Contact> all;
    for (std::size_t i = 0; i < collisions.size(); ++i) {
      all.push_back(plain::contact(collisions[i], bodies[2 * i], bodies[2 * i + 1]));
    }
    return all;
  }();
  for (const Law law : laws) {
    const auto solve = law == Law::frictionless ? plain::solve_frictionless : plain::solve_reflection;
    benchmark::RegisterBenchmark(plain_name(law).c_str(), [solve](benchmark::State& state) {
      std::vector<plain::Motions> motions(contacts.size());
      for (auto _ : state) {
        std::ranges::transform(contacts, motions.begin(), solve);
        benchmark::ClobberMemory();
      }
    });
  }
}

void register_batches() {
  for (const Law law : batch_laws) {
    for (const InstructionSet set : instruction_sets()) {
      register_batch<float>("float", law, in_cache, set);
      register_batch<double>("double", law, in_cache, set);
    }
  }
  for (const Law law : laws) {
    for (const InstructionSet set : instruction_sets()) {
      register_batch<double>("double", law, out_of_cache, set);
    }
    for (const std::size_t size : sizes) {
      if (size != in_cache && size != out_of_cache) {
        register_batch<double>("double", law, size, impulse::best_instruction_set());
      }
    }
  }
  for (const Law law : laws) {
    for (const auto& [name, collisions] : {std::pair{slender_name(law), colliding_slender(in_cache)},
                                           std::pair{tips_name(law), colliding_tips(in_cache)},
                                           std::pair{spheres_name(law), colliding_spheres(in_cache)}}) {
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        Workload<double> workload(collisions);
        for (auto _ : state) {
          impulse::solve(workload.contacts, law, workload.outcomes);
          benchmark::ClobberMemory();
        }
      });
    }
  }
  for (const std::size_t size : sizes) {
    benchmark::RegisterBenchmark(triad_name(size).c_str(), [size](benchmark::State& state) {
      for (auto _ : state) {
        triad(shared_workload<double>(size));
        benchmark::ClobberMemory();
      }
    });
  }
}

void register_threads() {
  for (const Law law : laws) {
    for (const std::size_t size : {in_cache, out_of_cache / 4}) {
      for (const unsigned threads : thread_counts()) {
        const auto measure = [=](benchmark::State& state) {
          Workload<double> workload(size);
          for (auto _ : state) {
            impulse::solve(workload.contacts, law, workload.outcomes);
            benchmark::ClobberMemory();
          }
        };
        benchmark::RegisterBenchmark(threads_name(law, size, threads).c_str(), measure)
            ->Threads(static_cast<int>(threads))
            ->UseRealTime();
      }
    }
  }
}

std::size_t multiply_and_add(InstructionSet set, double* sink) {
#ifdef CAROM_BATCH_HAS_avx512
  if (set == InstructionSet::avx512) {
    return avx512::multiply_and_add(sink);
  }
#endif
#ifdef CAROM_BATCH_HAS_avx2
  if (set == InstructionSet::avx2) {
    return avx2::multiply_and_add(sink);
  }
#endif
  return set == InstructionSet::baseline ? baseline::multiply_and_add(sink) : 0;
}

void register_peaks() {
  for (const InstructionSet set : instruction_sets()) {
    benchmark::RegisterBenchmark(peak_name(set).c_str(), [set](benchmark::State& state) {
      double sink[]{0.5, 1, 0};
      for (auto _ : state) {
        multiply_and_add(set, sink);
        benchmark::DoNotOptimize(sink);
      }
    });
  }
}

Operations operations_of(Law law) {
  const auto contact = colliding_batch<double>(1).at(0);
  const auto counted = [](const auto& matrix) { return matrix.template cast<Counted>().eval(); };
  const auto body = [&](const impulse::ContactBody<double>& b) {
    return impulse::ContactBody<Counted>{b.inverse_mass,
                                         {counted(b.inertia.axes), counted(b.inertia.inverse_moments)},
                                         counted(b.lever_arm),
                                         counted(b.velocity),
                                         counted(b.angular_velocity)};
  };
  const impulse::Contact<Counted> posed{body(contact.a),     body(contact.b),  counted(contact.normal),
                                        contact.restitution, contact.friction, contact.tangential_restitution};
  Counted::operations = {};
  impulse::with_law(law, [&](const auto& solver) { static_cast<void>(impulse::apply_impulse(posed, solver(posed))); });
  return Counted::operations;
}

/// Nanoseconds for each contact.
double per_contact(const Recorder& recorder, const std::string& name, std::size_t contacts) {
  return recorder.at(name).median() / static_cast<double>(contacts);
}

double gigabytes_per_second(const Recorder& recorder, const std::string& name, std::size_t contacts,
                            std::size_t bytes) {
  return static_cast<double>(bytes) / per_contact(recorder, name, contacts);
}

void print_methods(const Recorder& recorder) {
  if (!recorder.has(baseline_method)) {
    return;
  }
  const double baseline = recorder.at(baseline_method).median();
  fmt::print("\nEvery method, {} colliding contacts in cache, one thread\n", in_cache);
  fmt::print("  {:<42} {:>11} {:>8} {:>22}\n", "method", "ns/contact", "spread", baseline_method + std::string(" = 1"));
  for (const subjects::Method& method : methods()) {
    const std::string& name = method.subject.name;
    if (recorder.has(name)) {
      fmt::print("  {:<42} {:>11.2f} {:>7.1f}% {:>22.3f}\n", name, per_contact(recorder, name, in_cache),
                 100 * recorder.at(name).spread(), recorder.at(name).median() / baseline);
    }
  }
}

void print_instruction_sets(const Recorder& recorder) {
  fmt::print("\nBatches by instruction set, {} contacts in cache\n", in_cache);
  fmt::print("  {:<32} {:>11} {:>8} {:>22}\n", "batch", "ns/contact", "spread", baseline_method + std::string(" = 1"));
  for (const Law law : batch_laws) {
    for (const std::string scalar : {"float", "double"}) {
      for (const InstructionSet set : instruction_sets()) {
        const std::string name = batch_name(scalar, law, in_cache, set);
        if (recorder.has(name) && recorder.has(baseline_method)) {
          fmt::print("  {:<32} {:>11.2f} {:>7.1f}% {:>22.3f}\n",
                     fmt::format("{} {} {}", name_of(law), scalar, name_of(set)), per_contact(recorder, name, in_cache),
                     100 * recorder.at(name).spread(),
                     recorder.at(name).median() / recorder.at(baseline_method).median());
        }
      }
    }
  }
}

void print_plain(const Recorder& recorder) {
  const std::string reflection = plain_name(Law::reflection);
  if (!recorder.has(reflection)) {
    return;
  }
  fmt::print("\nBatches in double beside the note in plain C++, {} contacts in cache\n", in_cache);
  fmt::print("  {:<32} {:>11} {:>8} {:>16} {:>17}\n", "", "ns/contact", "spread", "plain, same law",
             "plain reflection");
  for (const Law law : laws) {
    std::vector<std::pair<std::string, std::string>> rows{{fmt::format("plain {}", name_of(law)), plain_name(law)}};
    for (const InstructionSet set : instruction_sets()) {
      rows.emplace_back(fmt::format("batch {} {}", name_of(law), name_of(set)),
                        batch_name("double", law, in_cache, set));
    }
    for (const auto& [title, name] : rows) {
      if (recorder.has(name) && recorder.has(plain_name(law))) {
        const double median = recorder.at(name).median();
        fmt::print("  {:<32} {:>11.2f} {:>7.1f}% {:>14.1f} × {:>15.1f} ×\n", title,
                   per_contact(recorder, name, in_cache), 100 * recorder.at(name).spread(),
                   recorder.at(plain_name(law)).median() / median, recorder.at(reflection).median() / median);
      }
    }
  }
}

void print_slender(const Recorder& recorder) {
  const InstructionSet best = impulse::best_instruction_set();
  fmt::print("\nBatches in double with slender bodies, {} contacts in cache, {}\n", in_cache, name_of(best));
  for (const Law law : laws) {
    const std::string usual = batch_name("double", law, in_cache, best);
    if (recorder.has(slender_name(law)) && recorder.has(usual)) {
      fmt::print("  {:<13} {:>8.2f} ns, {:.1f} times as long as without\n", name_of(law),
                 per_contact(recorder, slender_name(law), in_cache),
                 recorder.at(slender_name(law)).median() / recorder.at(usual).median());
    }
    if (recorder.has(slender_name(law)) && recorder.has(tips_name(law))) {
      fmt::print("  {:<13} {:>8.2f} ns if needles are struck on their tips, {:.1f} times as long as slender bodies\n",
                 name_of(law), per_contact(recorder, tips_name(law), in_cache),
                 recorder.at(tips_name(law)).median() / recorder.at(slender_name(law)).median());
    }
  }
}

void print_sizes(const Recorder& recorder) {
  fmt::print("\nBatches in double by number of contacts, {}\n", name_of(impulse::best_instruction_set()));
  fmt::print("  {:>9} {:>13} {:>6} {:>9} {:>13} {:>6} {:>9} {:>12}\n", "contacts", "frictionless", "GB/s", "triad = 1",
             "reflection", "GB/s", "triad = 1", "triad GB/s");
  for (const std::size_t size : sizes) {
    if (!recorder.has(triad_name(size))) {
      continue;
    }
    const double triad = gigabytes_per_second(recorder, triad_name(size), size, triad_bytes_of_contact);
    std::string line = fmt::format("  {:>9}", size);
    for (const Law law : laws) {
      const std::string name = batch_name("double", law, size, impulse::best_instruction_set());
      if (recorder.has(name)) {
        const double rate = gigabytes_per_second(recorder, name, size, bytes_of_contact<double>);
        line += fmt::format(" {:>10.2f} ns {:>6.1f} {:>9.2f}", per_contact(recorder, name, size), rate, rate / triad);
      }
    }
    fmt::print("{} {:>12.1f}\n", line, triad);
  }
}

void print_threads(const Recorder& recorder) {
  fmt::print("\nThreads over batches of their own, double, ns a contact of any thread and ratio to one thread\n");
  for (const Law law : laws) {
    for (const std::size_t size : {in_cache, out_of_cache / 4}) {
      std::string line = fmt::format("  {:<13} {:>7} contacts each:", name_of(law), size);
      for (const unsigned threads : thread_counts()) {
        const std::string name = threads_name(law, size, threads);
        if (recorder.has(name) && recorder.has(threads_name(law, size, 1))) {
          line += fmt::format("  {} thread{} {:.2f} ns ({:.2f})", threads, threads == 1 ? "" : "s",
                              per_contact(recorder, name, size),
                              recorder.at(threads_name(law, size, 1)).median() / recorder.at(name).median());
        }
      }
      fmt::print("{}\n", line);
    }
  }
}

/// The rate of the multiply-and-add loop [Gflop/s].
double peak(const Recorder& recorder, InstructionSet set) {
  double sink[]{0.5, 1, 0};
  return static_cast<double>(multiply_and_add(set, sink)) / recorder.at(peak_name(set)).median();
}

void print_roofline(const Recorder& recorder) {
  const InstructionSet best = impulse::best_instruction_set();
  if (!recorder.has(triad_name(out_of_cache)) || !recorder.has(peak_name(best))) {
    return;
  }
  const double bandwidth =
      gigabytes_per_second(recorder, triad_name(out_of_cache), out_of_cache, triad_bytes_of_contact);
  fmt::print("\nRoofline, one thread, double. Memory: {:.1f} GB/s (triad, {} contacts). Arithmetic, measured:",
             bandwidth, out_of_cache);
  for (const InstructionSet set : instruction_sets()) {
    fmt::print(" {} {:.1f}", name_of(set), peak(recorder, set));
  }
  fmt::print(" Gflop/s (multiply, add; not fused)\n");
  for (const Law law : laws) {
    const Operations operations = operations_of(law);
    const double intensity = static_cast<double>(operations.all()) / static_cast<double>(bytes_of_contact<double>);
    const double roof = std::min(peak(recorder, best), intensity * bandwidth);
    fmt::print("  {:<13} {} flop a contact ({} +, {} ×, {} ÷), {} bytes, {:.2f} flop/byte\n", name_of(law),
               operations.all(), operations.additions, operations.multiplications, operations.divisions,
               bytes_of_contact<double>, intensity);
    const auto reached = [&](std::size_t size) {
      return static_cast<double>(operations.all()) / per_contact(recorder, batch_name("double", law, size, best), size);
    };
    if (recorder.has(batch_name("double", law, in_cache, best))) {
      fmt::print("    in cache:     {:>6.1f} Gflop/s, {:.0f} % of the arithmetic roof ({:.1f})\n", reached(in_cache),
                 100 * reached(in_cache) / peak(recorder, best), peak(recorder, best));
    }
    if (recorder.has(batch_name("double", law, out_of_cache, best))) {
      fmt::print("    out of cache: {:>6.1f} Gflop/s, {:.0f} % of the roof ({:.1f}, {})\n", reached(out_of_cache),
                 100 * reached(out_of_cache) / roof, roof,
                 roof < peak(recorder, best) ? "bound by memory" : "bound by arithmetic");
    }
  }
}

const char* said(bool is_reached) { return is_reached ? "reached" : "not reached"; }

/// How much a batch computes, and how near it comes to the rate of the multiply-and-add loop.
void print_goals_of_batches(const Recorder& recorder) {
  const InstructionSet best = impulse::best_instruction_set();
  for (const auto& [law, goal] : {std::pair{Law::reflection, 300}, std::pair{Law::frictionless, 170}}) {
    const auto operations = operations_of(law).all();
    fmt::print("  {} of bodies that are not slender: {} flop a contact; goal at most {}: {}\n", name_of(law),
               operations, goal, said(operations <= goal));
    const std::string name = batch_name("double", law, in_cache, best);
    if (recorder.has(name) && recorder.has(peak_name(best))) {
      const double share =
          static_cast<double>(operations) / per_contact(recorder, name, in_cache) / peak(recorder, best);
      fmt::print("  {} in double, in cache: {:.0f} % of the arithmetic roof; goal at least 70 %: {}\n", name_of(law),
                 100 * share, said(share >= 0.7));
    }
    if (recorder.has(name) && recorder.has(spheres_name(law))) {
      const double ratio = recorder.at(name).median() / recorder.at(spheres_name(law)).median();
      fmt::print("  {} of spheres, in cache: {:.1f} times as quick as of general bodies; goal 3: {}\n", name_of(law),
                 ratio, said(ratio >= 3));
    }
  }
}

void print_goals(const Recorder& recorder) {
  const InstructionSet best = impulse::best_instruction_set();
  const std::string cached = batch_name("double", Law::reflection, in_cache, best);
  fmt::print("\nGoals\n");
  if (recorder.has(cached) && recorder.has(baseline_method)) {
    const double ratio = recorder.at(cached).median() / recorder.at(baseline_method).median();
    fmt::print("  reflection in double, in cache: 1/{:.1f} of {}; goal at most 1/8: {}\n", 1 / ratio, baseline_method,
               said(ratio <= 1.0 / 8));
  }
  const std::string rough = batch_name("double", Law::rough, in_cache, best);
  if (recorder.has(cached) && recorder.has(rough)) {
    const double ratio = recorder.at(rough).median() / recorder.at(cached).median();
    fmt::print("  rough in double, in cache: {:.2f} of reflection; goal at most 1.6: {}\n", ratio, said(ratio <= 1.6));
  }
  const std::string plain = plain_name(Law::reflection);
  for (const auto& [law, goal] : {std::pair{Law::reflection, 15}, std::pair{Law::frictionless, 20}}) {
    const std::string name = batch_name("double", law, in_cache, best);
    if (recorder.has(name) && recorder.has(plain)) {
      const double ratio = recorder.at(plain).median() / recorder.at(name).median();
      const double roof = recorder.has(peak_name(best))
                              ? per_contact(recorder, plain, in_cache) * peak(recorder, best) /
                                    static_cast<double>(operations_of(law).all())
                              : 0;
      fmt::print(
          "  {} in double, in cache: {:.1f} times as quick as the note (reflection) in plain C++, {:.1f} at the roof; "
          "goal {}: {}\n",
          name_of(law), ratio, roof, goal, said(ratio >= goal));
    }
  }
  for (const Law law : laws) {
    const std::string streamed = batch_name("double", law, out_of_cache, best);
    if (recorder.has(streamed) && recorder.has(triad_name(out_of_cache))) {
      const double share =
          gigabytes_per_second(recorder, streamed, out_of_cache, bytes_of_contact<double>) /
          gigabytes_per_second(recorder, triad_name(out_of_cache), out_of_cache, triad_bytes_of_contact);
      fmt::print("  {} in double, out of cache: {:.0f} % of the bytes a second of the triad; goal at least 70 %: {}\n",
                 name_of(law), 100 * share, said(share >= 0.7));
    }
  }
}

int run(int argc, char** argv) {
  // Options on the command line override these defaults.
  std::vector<std::string> words{argv[0], "--benchmark_repetitions=9", "--benchmark_min_time=0.02",
                                 "--benchmark_enable_random_interleaving=true"};
  words.insert(words.end(), argv + 1, argv + argc);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) {
    return 2;
  }
  register_methods();
  register_plain();
  register_batches();
  register_threads();
  register_peaks();
  Recorder recorder;
  benchmark::RunSpecifiedBenchmarks(&recorder);
  print_methods(recorder);
  print_instruction_sets(recorder);
  print_plain(recorder);
  print_slender(recorder);
  print_sizes(recorder);
  print_threads(recorder);
  print_roofline(recorder);
  print_goals(recorder);
  print_goals_of_batches(recorder);
  return 0;
}

}  // namespace
}  // namespace carom::benchmarks

int main(int argc, char** argv) {
  return carom::unit::exit_status("solvers", [&] { return carom::benchmarks::run(argc, argv); });
}
