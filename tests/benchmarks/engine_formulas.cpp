// SPDX-License-Identifier: BSL-1.0
// Compares the friction of the engines with formulas (docs/reference/engines.md): engine_formulas [CASES]
//
// Prints the distance of each engine's impulse from its formula, and from the law `coulomb`. Bodies are real, and a
// body's moments differ by a factor of at most 100. If the formula omits gyroscopic torque, the bodies do not spin.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <carom/impulse/coulomb.hpp>
#include <carom/properties/families/family.hpp>
#include <carom/subjects/catalogue.hpp>

#include "subjects/engines/formulas/formulas.hpp"
#include "support/exit_status.hpp"

namespace carom::benchmarks {
namespace {

constexpr std::array frictions{0.1, 0.3, 0.6, 1.0, 5.0};
constexpr double time_limit = 60;  // after this time, an engine counts as hung [s]

/// Whether the moments differ too much for an engine that keeps inertia in world coordinates in binary32.
bool is_slender(const Body& body) {
  constexpr double limit = 100;
  return !body.immovable && body.principal_inertia.maxCoeff() > limit * body.principal_inertia.minCoeff();
}

/// Colliding contacts of the family `physical` whose bodies are not slender. Each contact occurs once for every μ of
/// `frictions`.
std::vector<Collision> contacts(std::uint64_t cases, bool spin) {
  const properties::Family* const family = properties::family_named("physical");
  std::vector<Collision> drawn;
  for (std::uint64_t i = 0; drawn.size() < cases * frictions.size(); ++i) {
    Collision collision = properties::drawn_case(*family, 1, i).collision;
    if (!spin) {
      collision.a.angular_velocity.setZero();
      collision.b.angular_velocity.setZero();
    }
    const auto contact = impulse::make_contact<double>(collision);
    if (!impulse::is_colliding(contact, impulse::normal_velocity(contact)) || is_slender(collision.a) ||
        is_slender(collision.b)) {
      continue;
    }
    for (const double friction : frictions) {
      collision.friction = friction;
      drawn.push_back(collision);
    }
  }
  return drawn;
}

template <class S>
Vector3<double> impulse_of(const Collision& collision, const Outcome<S>& after) {
  const bool reads_b = collision.a.immovable;
  const Body& body = reads_b ? collision.b : collision.a;
  const Vector3<S> change = (reads_b ? after.b : after.a).velocity - body.velocity.template cast<S>();
  return (change * static_cast<S>(reads_b ? -body.mass : body.mass)).template cast<double>();
}

/// Quantiles of relative differences. If the engine gives no answer, the difference is infinite.
struct Differences {
  std::vector<double> of_norm;

  [[nodiscard]] double at(double share) {
    std::sort(of_norm.begin(), of_norm.end());
    return of_norm[static_cast<std::size_t>(share * static_cast<double>(of_norm.size() - 1))];
  }
};

struct Measured {
  Differences from_formula;
  std::array<Differences, frictions.size()> from_law;
};

Measured measure(const Subject& subject, const formulas::OutcomeOf& formula, std::uint64_t cases) {
  const std::vector<Collision> collisions = contacts(cases, !formulas::leaves_out_gyroscopic_torque(subject.name));
  Session session = subject.open();
  const std::vector<Answer> answers = session(collisions);
  Measured measured;
  for (std::size_t i = 0; i < collisions.size(); ++i) {
    const Collision& collision = collisions[i];
    const auto* const outcome = std::get_if<ReportedOutcome>(&answers[i]);
    const bool has_answer = outcome != nullptr && outcome->a.velocity.allFinite() && outcome->b.velocity.allFinite();
    const Vector3<double> by_engine =
        has_answer ? impulse_of(collision, *outcome) : Vector3<double>::Constant(HUGE_VAL);
    const Vector3<double> lawful = impulse::coulomb_impulse(impulse::make_contact<double>(collision)).on_a;
    const Vector3<double> computed = impulse_of(collision, formula(collision));
    // Gyroscopic torque can make an engine and its formula give no impulse on a colliding contact. So the larger of the
    // impulses by the formula and by the law scales the difference.
    const double size = std::max(computed.norm(), lawful.norm());
    measured.from_formula.of_norm.push_back((by_engine - computed).norm() / size);
    measured.from_law[i % frictions.size()].of_norm.push_back((by_engine - lawful).norm() / lawful.norm());
  }
  session.close();
  return measured;
}

int run(int argc, char** argv) {
  std::uint64_t cases = 1000;
  if (argc > 1) {
    const std::string_view word = argv[1];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), cases);
    if (argc > 2 || error != std::errc() || end != word.data() + word.size() || cases == 0) {
      throw std::invalid_argument("expected one number greater than 0, CASES");
    }
  }
  fmt::print(
      "{} contacts of `physical`, each at {} coefficients of friction\n\n"
      "| subject | ‖F − F_formula‖ / max(‖F_formula‖, ‖F_coulomb‖): median | 99 % | worst |",
      cases, frictions.size());
  for (const double friction : frictions) {
    fmt::print(" ‖F − F_coulomb‖ / ‖F_coulomb‖ at μ = {}: median, 99 % |", friction);
  }
  fmt::print("\n| --- | ---: | ---: | ---: |");
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    fmt::print(" --- |");
  }
  fmt::print("\n");
  for (const Subject& subject : subjects::engine_subjects(subjects::protocol::exec_options(time_limit, {}))) {
    const formulas::OutcomeOf* const formula = formulas::formula_of(subject.name);
    if (formula == nullptr || !subject.absent.empty()) {
      continue;
    }
    Measured measured = measure(subject, *formula, cases);
    Differences& differences = measured.from_formula;
    fmt::print("| {} {} | {:.1e} | {:.1e} | {:.1e} |", subject.name, subject.version, differences.at(0.5),
               differences.at(0.99), differences.at(1));
    for (Differences& from_law : measured.from_law) {
      fmt::print(" {:.1e}, {:.1e} |", from_law.at(0.5), from_law.at(0.99));
    }
    fmt::print("\n");
  }
  return 0;
}

}  // namespace
}  // namespace carom::benchmarks

int main(int argc, char** argv) {
  return carom::unit::exit_status("engine_formulas", [&] { return carom::benchmarks::run(argc, argv); });
}
