// SPDX-License-Identifier: BSL-1.0
// Solves per second over the line protocol, without judging: protocol_rate 'exec:PROGRAM ARG…' [THREADS]
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

#include <fmt/format.h>

#include <carom/properties/families/family.hpp>
#include <carom/subjects/protocol/exec.hpp>

#include "support/exit_status.hpp"

namespace carom::benchmarks {
namespace {

constexpr std::size_t batch = 500;  // about the size of the gate's batches
constexpr std::chrono::seconds duration{5};

std::vector<Collision> valid_collisions() {
  std::vector<Collision> collisions;
  for (std::uint64_t i = 0; i < batch; ++i) {
    properties::Stream stream = properties::case_stream(1, "generic", i);
    collisions.push_back(properties::family_named("generic")->generate(stream).collision);
  }
  return collisions;
}

int run(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "protocol_rate 'exec:PROGRAM ARG…' [THREADS]\n";
    return 2;
  }
  const unsigned threads = argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 2;
  const Subject subject = subjects::protocol::exec_subject(argv[1], {});
  const std::vector<Collision> collisions = valid_collisions();
  std::vector<std::size_t> solved(threads, 0);
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < threads; ++i) {
      workers.emplace_back([&, i] {
        Session session = subject.open();
        const auto end = std::chrono::steady_clock::now() + duration;
        while (std::chrono::steady_clock::now() < end) {
          solved[i] += session(collisions).size();
        }
        session.close();
      });
    }
  }
  std::size_t sum = 0;
  for (const std::size_t count : solved) {
    sum += count;
  }
  fmt::print("{}: {:.0f} solves a second, {} threads\n", subject.name,
             static_cast<double>(sum) / static_cast<double>(duration.count()), threads);
  return 0;
}

}  // namespace
}  // namespace carom::benchmarks

int main(int argc, char** argv) {
  return carom::unit::exit_status("protocol_rate", [&] { return carom::benchmarks::run(argc, argv); });
}
