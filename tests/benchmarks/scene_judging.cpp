// SPDX-License-Identifier: BSL-1.0
// The time to judge a scene under each law: scene_judging FILE [ROUNDS]. Prints medians over the rounds, in processor
// time.
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/properties/scenes/history.hpp>
#include <carom/properties/scenes/judged_impulses.hpp>
#include <carom/properties/scenes/ledger.hpp>
#include <carom/properties/scenes/validity.hpp>
#include <carom/scene/json/scene_json.hpp>
#include <carom/scene/polyhedra/scene_simulation.hpp>

namespace {

using carom::Law;
using carom::scene::Event;
using carom::scene::Scene;
using carom::scene::SceneSimulation;

double seconds_of(const auto& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

std::vector<Event> events_of(SceneSimulation& simulation) {
  std::vector<Event> events;
  while (const Event* event = simulation.advance()) {
    events.push_back(*event);
  }
  return events;
}

double median(std::vector<double> times) {
  std::ranges::sort(times);
  return times[times.size() / 2];
}

void print_row(const Scene& scene, int rounds) {
  std::vector<double> loop, judge, ledger, check;
  std::size_t impulses = 0;
  std::size_t count = 0;
  for (int round = 0; round < rounds; ++round) {
    const SceneSimulation at_first(scene);
    std::vector<Event> events;
    loop.push_back(seconds_of([&] {
      SceneSimulation simulation(scene);
      events = events_of(simulation);
    }));
    count = events.size();
    carom::properties::ImpulseJudge judged(scene.law, scene.precision, 1, {});
    judge.push_back(seconds_of([&] { std::ranges::for_each(events, [&](const Event& e) { judged.record(e); }); }));
    impulses = judged.judged();
    carom::properties::Ledger booked(at_first.state());
    ledger.push_back(seconds_of([&] { std::ranges::for_each(events, [&](const Event& e) { booked.record(e); }); }));
    check.push_back(seconds_of([&] {
      carom::properties::History history(at_first.state());
      std::ranges::for_each(events, [&](const Event& e) { history.record(e); });
      if (check_validity(scene, history).count > 0) {
        fmt::print("overlaps!\n");
      }
    }));
  }
  const auto microseconds = [](const std::vector<double>& times, std::size_t each) {
    return 1e6 * median(times) / static_cast<double>(std::max<std::size_t>(each, 1));
  };
  fmt::print("{:<14}{:>8}{:>10}{:>20.2f}{:>24.1f}{:>23.2f}{:>24.1f}\n", name_of(scene.law), count, impulses,
             microseconds(loop, count), microseconds(judge, impulses), microseconds(ledger, count),
             microseconds(check, count));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "scene_judging FILE [ROUNDS]\n");
    return 2;
  }
  std::ifstream file(argv[1]);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  Scene scene = carom::scene::scene_from_json(carom::parse_json(text));
  const int rounds = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
  fmt::print("{:<14}{:>8}{:>10}{:>20}{:>24}{:>23}{:>24}\n", "law", "events", "impulses", "loop, µs an event",
             "judge, µs an impulse", "ledger, µs an event", "check, µs an event");
  for (const Law law : {Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb}) {
    scene.law = law;
    print_row(scene, rounds);
  }
}
