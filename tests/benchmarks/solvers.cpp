// SPDX-License-Identifier: BSL-1.0
// Times the solvers: solvers [--benchmark_…]. Prints medians, and their ratios to two baselines of the same run. A run
// takes about a minute.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <carom/impulse/batch/solve.hpp>
#include <carom/impulse/laws.hpp>
#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/draws/stream.hpp>
#include <carom/subjects/methods.hpp>

#include "plain_note.hpp"
#include "support/exit_status.hpp"

namespace carom::benchmarks {
namespace {

using impulse::InstructionSet;

/// In double, this many contacts with their outcomes take 36 KB: more than a first-level cache of 32 KiB.
constexpr std::size_t in_cache = 64;
/// In double, this many contacts fit into no cache (384 MB).
constexpr std::size_t out_of_cache = 1'000'000;

constexpr const char* baseline_method = "reflection-llt-double";
constexpr Law laws[]{Law::frictionless, Law::reflection};

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> available;
  std::ranges::copy_if(impulse::all_instruction_sets, std::back_inserter(available), impulse::is_available);
  return available;
}

/// The first `count` colliding contacts of a fixed sequence.
template <class Generate>
std::vector<Collision> colliding(const Generate& generate, std::size_t count) {
  std::vector<Collision> collisions;
  for (std::uint64_t i = 0; collisions.size() < count; ++i) {
    properties::Stream stream = properties::case_stream(1, "benchmarks", i);
    const Collision collision = generate(stream).collision;
    const auto contact = impulse::make_contact<double>(collision);
    if (is_colliding(contact, normal_velocity(contact))) {
      collisions.push_back(collision);
    }
  }
  return collisions;
}

/// The greatest moment of a body is at most 4 times its least moment.
const std::vector<Collision>& usual_collisions() {
  static const std::vector<Collision> all = colliding(properties::general_bodies, 4096);
  return all;
}

/// A batch of `count` contacts of these collisions. If the collisions are fewer, they repeat.
template <class S>
struct Workload {
  Workload(const std::vector<Collision>& collisions, std::size_t count) : contacts(count), outcomes(count) {
    for (std::size_t i = 0; i < count; ++i) {
      contacts.set(i, impulse::make_contact<S>(collisions[i % collisions.size()]));
    }
  }

  impulse::ContactBatch<S> contacts;
  impulse::OutcomeBatch<S> outcomes;
};

template <class S>
Workload<S>& usual_workload(std::size_t count) {
  static std::map<std::size_t, Workload<S>> workloads;
  return workloads.try_emplace(count, usual_collisions(), count).first->second;
}

/// Keeps Google Benchmark's measurements by name, in nanoseconds per iteration, and shows progress as dots. Repetitions
/// of different benchmarks alternate. So the median tolerates a machine that is busy during less than half of the
/// repetitions.
class Recorder : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration && !run.error_occurred) {
        // function_name omits suffixes that Google Benchmark adds.
        measurements_[run.run_name.function_name].push_back(run.cpu_accumulated_time * 1e9 /
                                                            static_cast<double>(run.iterations));
      }
    }
    GetErrorStream() << '.' << std::flush;
  }

  /// NaN if the benchmark did not run.
  [[nodiscard]] double median(const std::string& name) const { return quantile(name, 0.5); }
  /// Half the interquartile range divided by the median.
  [[nodiscard]] double spread(const std::string& name) const {
    return (quantile(name, 0.75) - quantile(name, 0.25)) / 2 / median(name);
  }

 private:
  [[nodiscard]] double quantile(const std::string& name, double share) const {
    const auto found = measurements_.find(name);
    if (found == measurements_.end()) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    std::vector<double> numbers = found->second;
    std::ranges::sort(numbers);
    const double place = share * static_cast<double>(numbers.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(place));
    return std::lerp(numbers[below], numbers[std::min(below + 1, numbers.size() - 1)], place - std::floor(place));
  }

  std::map<std::string, std::vector<double>> measurements_;
};

struct Registered {
  std::string name;
  std::size_t contacts;
};

std::vector<Registered>& registered() {
  static std::vector<Registered> all;
  return all;
}

/// `prepare` makes the function that is timed.
template <class Prepare>
void add(const std::string& name, std::size_t contacts, const Prepare& prepare) {
  registered().push_back({name, contacts});
  benchmark::RegisterBenchmark(name.c_str(), [prepare](benchmark::State& state) {
    const auto timed = prepare();
    for ([[maybe_unused]] const auto _ : state) {
      timed();
      benchmark::ClobberMemory();
    }
  });
}

void add_methods() {
  static const std::vector<subjects::Method> methods = subjects::methods();
  for (const subjects::Method& method : methods) {
    add(method.subject.name, in_cache,
        [&method] { return method.prepare(std::span(usual_collisions()).first(in_cache)); });
  }
}

/// The note's bodies and contacts for the first collisions.
struct PlainContacts {
  std::vector<plain::RigidBody> bodies;
  std::vector<plain::Contact> contacts;
};

const PlainContacts& plain_contacts() {
  static const PlainContacts all = [] {
    PlainContacts made;
    for (const Collision& collision : std::span(usual_collisions()).first(in_cache)) {
      made.bodies.push_back(plain::rigid_body(collision.a));
      made.bodies.push_back(plain::rigid_body(collision.b));
    }
    for (std::size_t i = 0; i < in_cache; ++i) {
      made.contacts.push_back(plain::contact(usual_collisions()[i], made.bodies[2 * i], made.bodies[2 * i + 1]));
    }
    return made;
  }();
  return all;
}

/// Throws std::logic_error if the note in plain C++ gives other outcomes than the library.
void check_plain(Law law, plain::Motions (*solve)(const plain::Contact&)) {
  constexpr double tolerance = 1e-10;  // 10⁵ ulps
  for (std::size_t i = 0; i < in_cache; ++i) {
    const auto contact = impulse::make_contact<double>(usual_collisions()[i]);
    const Outcome<double> found = plain::outcome(solve(plain_contacts().contacts[i]));
    Outcome<double> expected;
    impulse::with_law(law, [&](const auto& solver) { expected = impulse::apply_impulse(contact, solver(contact)); });
    for (const OutcomeVector k : all_outcome_vectors) {
      if (!(*vectors(found)[k]).isApprox(*vectors(expected)[k], tolerance)) {
        throw std::logic_error("the note in plain C++ gives another outcome");
      }
    }
  }
}

void add_plain() {
  for (const Law law : laws) {
    const auto solve = law == Law::frictionless ? plain::solve_frictionless : plain::solve_reflection;
    check_plain(law, solve);
    add(fmt::format("plain/{}", name_of(law)), in_cache, [solve] {
      return [solve, motions = std::make_shared<std::vector<plain::Motions>>(in_cache)] {
        std::ranges::transform(plain_contacts().contacts, motions->begin(), solve);
      };
    });
  }
}

std::string batch_name(const std::string& scalar, Law law, std::size_t count, InstructionSet set) {
  return fmt::format("batch/{}/{}/{}/{}", name_of(law), scalar, count, name_of(set));
}

template <class S>
void add_batch(const std::string& scalar, Law law, std::size_t count, InstructionSet set) {
  add(batch_name(scalar, law, count, set), count, [=] {
    Workload<S>& workload = usual_workload<S>(count);
    return [&workload, law, set] { impulse::solve(workload.contacts, law, workload.outcomes, set); };
  });
}

void add_batches() {
  for (const InstructionSet set : instruction_sets()) {
    for (const Law law : {Law::frictionless, Law::reflection, Law::rough}) {
      add_batch<float>("float", law, in_cache, set);
      add_batch<double>("double", law, in_cache, set);
    }
    for (const Law law : laws) {
      add_batch<double>("double", law, out_of_cache, set);
    }
  }
  for (const Law law : laws) {
    // Slender bodies have moments of up to 1 : 10⁸. About half of them are plates or rods. A needle is struck on its
    // tip.
    for (const auto& [kind, collisions] : {std::pair{"slender", colliding(properties::convex_bodies, in_cache)},
                                           std::pair{"tips", colliding(properties::needle_tip, in_cache)},
                                           std::pair{"spheres", colliding(properties::touching_spheres, in_cache)}}) {
      add(fmt::format("{}/{}", kind, name_of(law)), in_cache, [law, collisions = collisions] {
        return [law, workload = std::make_shared<Workload<double>>(collisions, in_cache)] {
          impulse::solve(workload->contacts, law, workload->outcomes);
        };
      });
    }
  }
}

void print_times(const Recorder& recorder) {
  fmt::print("\n{:<46} {:>10} {:>11} {:>8} {:>22} {:>17}\n", "", "contacts", "ns/contact", "spread",
             std::string(baseline_method) + " = 1", "note in C++ = 1");
  for (const auto& [name, contacts] : registered()) {
    const double each = recorder.median(name) / static_cast<double>(contacts);
    const auto over = [&](const char* other) { return each * in_cache / recorder.median(other); };
    if (!std::isnan(each)) {
      fmt::print("{:<46} {:>10} {:>11.2f} {:>7.1f}% {:>22.3f} {:>17.3f}\n", name, contacts, each,
                 100 * recorder.spread(name), over(baseline_method), over("plain/reflection"));
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
  add_methods();
  add_plain();
  add_batches();
  Recorder recorder;
  benchmark::RunSpecifiedBenchmarks(&recorder);
  print_times(recorder);
  return 0;
}

}  // namespace
}  // namespace carom::benchmarks

int main(int argc, char** argv) {
  return carom::unit::exit_status("solvers", [&] { return carom::benchmarks::run(argc, argv); });
}
