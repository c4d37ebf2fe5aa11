// SPDX-License-Identifier: BSL-1.0
// Compares the laws with friction (docs/findings/friction.md): friction_laws [CASES]
//
// Prints tables by μ and the condition number of the collision matrix. The tables show how many collisions have several
// answers under `coulomb`. For the first answer, they show how often it creates energy, and its distance from the
// answer of `rough` at e_t = 0.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <carom/impulse/rough.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/truths/coulomb.hpp>
#include <carom/properties/cases/family.hpp>

#include "support/exit_status.hpp"

namespace carom::benchmarks {
namespace {

constexpr std::array frictions{0.1, 0.3, 0.6, 1.0, 5.0};
constexpr std::array condition_limits{4.0, 16.0, 100.0, 1e4, 1e300};

constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();

struct Cell {
  std::uint64_t cases = 0;
  std::uint64_t several = 0;
  std::uint64_t most = 0;
  std::uint64_t example = none;  // the number of the first case with several answers
  std::uint64_t create_energy = 0;
  std::vector<double> differences;  // ‖F_coulomb − F_rough‖ / ‖F_rough‖

  Cell& operator+=(const Cell& other) {
    cases += other.cases;
    several += other.several;
    most = std::max(most, other.most);
    example = std::min(example, other.example);
    create_energy += other.create_energy;
    differences.insert(differences.end(), other.differences.begin(), other.differences.end());
    return *this;
  }
};

using Row = std::array<Cell, condition_limits.size()>;
using Map = std::array<Row, frictions.size()>;

std::size_t place_of(const Matrix3<oracles::Rational>& k) {
  const Eigen::SelfAdjointEigenSolver<Matrix3<double>> solver(
      Matrix3<double>(k.unaryExpr([](const oracles::Rational& x) { return oracles::to_double(x); })));
  const double condition = solver.eigenvalues()[2] / solver.eigenvalues()[0];
  std::size_t place = 0;
  while (place + 1 < condition_limits.size() && !(condition <= condition_limits[place])) {
    ++place;
  }
  return place;
}

void add_case(std::uint64_t index, Collision collision, Map& map) {
  collision.tangential_restitution = 0;
  const oracles::ExactCase exact_case(collision);
  if (exact_case.state() != oracles::ContactState::colliding) {
    return;
  }
  const std::size_t condition = place_of(exact_case.collision_matrix());
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    collision.friction = frictions[i];
    const BasicCollision<oracles::Rational> c = oracles::lift(collision);
    const std::vector<oracles::CoulombAnswer> answers = oracles::coulomb_answers(c);
    Cell& cell = map[i][condition];
    ++cell.cases;
    if (answers.size() > 1) {
      ++cell.several;
      cell.example = std::min(cell.example, index);
    }
    cell.most = std::max<std::uint64_t>(cell.most, answers.size());
    const auto energy = oracles::equation::Energy{}(c, answers.front().truth.outcome);
    cell.create_energy += energy.left[0] > energy.right[0] ? 1 : 0;
    const Vector3<double> rough = acting_impulse(impulse::rough_impulse(impulse::make_contact<double>(collision))).on_a;
    const Vector3<double> coulomb =
        answers.front().truth.impulse.unaryExpr([](const oracles::Rational& x) { return oracles::to_double(x); });
    cell.differences.push_back((coulomb - rough).norm() / rough.norm());
  }
}

Map map_of(std::string_view family_name, std::uint64_t cases) {
  const properties::Family* const family = properties::family_named(family_name);
  const unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  std::vector<Map> maps(jobs);
  std::atomic<std::uint64_t> next = 0;
  {
    std::vector<std::jthread> threads;
    for (Map& map : maps) {
      threads.emplace_back([&] {
        for (std::uint64_t i = next++; i < cases; i = next++) {
          add_case(i, properties::drawn_case(*family, 1, i).collision, map);
        }
      });
    }
  }
  for (std::size_t job = 1; job < jobs; ++job) {
    for (std::size_t i = 0; i < frictions.size(); ++i) {
      for (std::size_t k = 0; k < condition_limits.size(); ++k) {
        maps[0][i][k] += maps[job][i][k];
      }
    }
  }
  return maps[0];
}

void print_map(std::string_view family, const Map& map) {
  fmt::print("{}: collisions with several answers, of all; the most answers, and the first such case\n\n| μ |", family);
  for (std::size_t k = 0; k < condition_limits.size(); ++k) {
    fmt::print("{}",
               k + 1 < condition_limits.size() ? fmt::format(" κ(K) ≤ {:g} |", condition_limits[k]) : " beyond |");
  }
  fmt::print(" create energy | median of ‖F_coulomb − F_rough‖ / ‖F_rough‖ |\n| ---: |{} ---: | ---: |\n",
             " --- | --- | --- | --- | --- |");
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    fmt::print("| {} |", frictions[i]);
    Cell all;
    for (const Cell& cell : map[i]) {
      all += cell;
      fmt::print(" {} of {}{} |", cell.several, cell.cases,
                 cell.several > 0 ? fmt::format("; {}, case {}", cell.most, cell.example) : "");
    }
    std::sort(all.differences.begin(), all.differences.end());
    fmt::print(" {:.2f} % | {:.2g} |\n",
               100.0 * static_cast<double>(all.create_energy) / static_cast<double>(all.cases),
               all.differences[all.differences.size() / 2]);
  }
  fmt::print("\n");
}

int run(int argc, char** argv) {
  const std::uint64_t cases = argc > 1 ? std::stoull(argv[1]) : 1000;
  if (cases == 0) {
    throw std::invalid_argument("CASES: expected a number greater than 0");
  }
  for (const char* family : {"physical", "collinear_spheres", "structured"}) {
    print_map(family, map_of(family, cases));
  }
  return 0;
}

}  // namespace
}  // namespace carom::benchmarks

int main(int argc, char** argv) {
  return carom::unit::exit_status("friction_laws", [&] { return carom::benchmarks::run(argc, argv); });
}
