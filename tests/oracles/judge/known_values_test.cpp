// SPDX-License-Identifier: BSL-1.0
#include "support/known_values.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/models/sensitivity.hpp>

#include "support/known_collisions.hpp"

/// The judge's numbers for a few collisions. Users rely on them, because an outcome that passes must pass in the next
/// release. A deliberate change of a number also changes known_values.txt and docs/CHANGELOG.md.
namespace carom::oracles {
namespace {

using unit::KnownCollision;
using unit::KnownLine;

/// The allowances of binary32 and binary64, and one whose square is not negligible.
constexpr std::array allowances{0x1p-6, 0x1p-19, 0x1p-48};

Yardstick yardstick_of(double allowance) {
  Yardstick yardstick;
  yardstick.unit_roundoff = allowance / default_limit_ulps;
  return yardstick;
}

std::string name_of_line(const KnownCollision& known, double allowance, const std::string& what) {
  return known.name + ", 2^" + std::to_string(std::ilogb(allowance)) + ", " + what;
}

void append(std::vector<double>& numbers, const PerVector<double>& more) {
  numbers.insert(numbers.end(), more.begin(), more.end());
}

ReportedOutcome moved(const Collision& c, double times) {
  Outcome<double> outcome = unchanged(c);
  const std::array<Vector3<double>, 4> by{Vector3<double>{5, 16, -3}, {2, -7, 1}, {-6, -11, 4}, {8, 3, -1}};
  std::size_t next = 0;
  for (Vector3<double>* vector : vectors(outcome)) {
    *vector += times * by[next++];
  }
  return reported(outcome);
}

struct Asked {
  Equation equation;
  Relation relation;
  bool needs_a;
  bool needs_b;
};

std::vector<Asked> asked_equations() {
  std::vector<Asked> all{{equation::LinearMomentum{}, Relation::equal, true, true},
                         {equation::TotalAngularMomentum{}, Relation::equal, true, true},
                         {equation::Restitution{}, Relation::equal, false, false},
                         {equation::NonPenetration{}, Relation::at_least, false, false},
                         {equation::ReflectionPlane{}, Relation::equal, false, false},
                         {equation::Sticks{}, Relation::equal, false, false},
                         {equation::Energy{}, Relation::at_most, false, false}};
  for (const bool a : {true, false}) {
    all.push_back({equation::AngularMomentum{a}, Relation::equal, a, !a});
    for (const OutcomeVector k : vectors_of_body(a)) {
      all.push_back({equation::Untouched{k}, Relation::equal, false, false});
    }
    all.push_back({equation::Push{a}, Relation::at_least, a, !a});
    all.push_back({equation::FrictionlessDirection{a}, Relation::equal, a, !a});
    all.push_back({equation::FrictionCone{a}, Relation::at_most, a, !a});
    all.push_back({equation::FrictionAlongSlip{a}, Relation::equal, a, !a});
    all.push_back({equation::FrictionAgainstSlip{a}, Relation::at_most, a, !a});
  }
  return all;
}

KnownLine comparisons(const std::string& name, const Collision& collision, const ReportedOutcome& reported,
                      const Yardstick& yardstick) {
  const ExactCase exact_case(collision);
  const LiftedOutcome outcome(reported);
  KnownLine line{name, {}};
  for (const Asked& asked : asked_equations()) {
    if ((asked.needs_a && collision.a.immovable) || (asked.needs_b && collision.b.immovable)) {
      continue;
    }
    const Comparison result = compare(asked.equation, asked.relation, exact_case, outcome, yardstick);
    line.numbers.insert(line.numbers.end(), {result.is_decided ? 1.0 : 0.0, result.residual, result.allowed});
  }
  return line;
}

/// Compares four outcomes: moved far, moved far in the opposite direction, moved a little, and moved far with digits
/// beyond binary64.
void add_comparisons(const KnownCollision& known, double allowance, std::vector<KnownLine>& lines) {
  for (const double times : {1.0, -1.0, 0x1p-12}) {
    lines.push_back(comparisons(name_of_line(known, allowance, "equations by " + std::to_string(times)),
                                known.collision, moved(known.collision, times), yardstick_of(allowance)));
  }
  ReportedOutcome extended = moved(known.collision, 1);
  for (Vector3<long double>* vector : vectors(extended)) {
    *vector *= 1 + 0x1p-60L;
  }
  lines.push_back(comparisons(name_of_line(known, allowance, "equations in extended precision"), known.collision,
                              extended, yardstick_of(allowance)));
}

/// Compares as if the subject's numbers below 1/4 lost digits by underflow.
void add_underflow(const KnownCollision& known, std::vector<KnownLine>& lines) {
  Yardstick yardstick = yardstick_of(0x1p-19);
  yardstick.least_size = 0.25;
  lines.push_back(
      comparisons(known.name + ", equations with underflow", known.collision, moved(known.collision, 1), yardstick));
}

/// Counts the allowances at which each fact holds. A limit that moves by a fifth changes a count.
void add_facts(const KnownCollision& known, std::vector<KnownLine>& lines) {
  const ExactCase exact_case(known.collision);
  double grazing = 0;
  double permitted = 0;
  PerLaw<double> two_answers{};
  PerLaw<double> open{};
  for (int i = 4; i < 4 * 52; ++i) {
    const double allowance = std::exp2(-i / 4.0);
    grazing += exact_case.is_grazing(allowance) ? 1 : 0;
    permitted += exact_case.permitted_inputs(allowance) != nullptr ? 1 : 0;
    for (const Law law : laws_with_truth) {
      two_answers[law] += exact_case.has_two_answers(law, allowance) ? 1 : 0;
      open[law] += exact_case.is_open(law, allowance) ? 1 : 0;
    }
  }
  KnownLine line{known.name + ", facts", {grazing, permitted}};
  for (const Law law : laws_with_truth) {
    line.numbers.insert(line.numbers.end(), {two_answers[law], open[law]});
  }
  lines.push_back(std::move(line));
}

void add_bounds(const KnownCollision& known, std::vector<KnownLine>& lines) {
  const ExactCase exact_case(known.collision);
  const BoundedCase& bounds = exact_case.bounds();
  KnownLine line{known.name + ", bounds", {}};
  append(line.numbers, bounds.norms_before());
  const ConeDistance enclosed = enclosed_cone_distance(known.collision);
  line.numbers.insert(line.numbers.end(), {enclosed.distance, enclosed.sensitivity});
  for (const Branch branch : {Branch::only, Branch::on_cone}) {
    line.numbers.push_back(growth_of_roundings(known.collision, bounds.enclosed(), Law::rough, branch));
  }
  if (bounds.is_moderate()) {
    const ConeDistance roughly = cone_distance(known.collision);
    line.numbers.insert(line.numbers.end(),
                        {roughly.distance, roughly.sensitivity, bounds.collision_matrix_sensitivity_below()});
    for (const Law law : laws_with_truth) {
      if (exact_case.branch(law) != Branch::on_cone || bounds.has_clear_divisor()) {
        append(line.numbers, bounds.colliding_sensitivity_below(law, exact_case.branch(law)));
      }
      if (known.name == "plain" || known.name == "much_friction") {  // exact derivatives take long
        append(line.numbers, exact_sensitivity(known.collision, law, exact_case.branch(law)));
        if (law == Law::rough && exact_case.branch(law) != Branch::on_cone) {
          append(line.numbers, exact_sensitivity(known.collision, law, Branch::on_cone));
        }
      }
    }
  }
  lines.push_back(std::move(line));
}

void add_accuracies(const KnownCollision& known, double allowance, std::vector<KnownLine>& lines) {
  const ExactCase exact_case(known.collision);
  for (const Law law : laws_with_truth) {
    KnownLine line{name_of_line(known, allowance, std::string(name_of(law))), {}};
    line.numbers = {
        exact_case.is_grazing(allowance) ? 1.0 : 0.0, exact_case.has_two_answers(law, allowance) ? 1.0 : 0.0,
        exact_case.is_open(law, allowance) ? 1.0 : 0.0, static_cast<double>(static_cast<int>(exact_case.branch(law)))};
    append(line.numbers, exact_case.sensitivity(law, allowance));
    append(line.numbers, exact_case.sensitivity_as(law, Approach::colliding, allowance));
    append(line.numbers, exact_case.sensitivity_as(law, Approach::separating, allowance));
    for (const double times : {0.0, 1.0, 0x1p-12}) {
      const Accuracy result =
          accuracy(exact_case, law, LiftedOutcome(moved(known.collision, times)), yardstick_of(allowance));
      append(line.numbers, result.error);
      line.numbers.push_back(result.relative_error);
      line.numbers.push_back(result.digits());
      line.numbers.push_back(result.backward_error(1));
      line.numbers.push_back((result.is_decided ? 1 : 0) + (result.is_allowed() ? 2 : 0) +
                             (result.is_of_truth ? 4 : 0));
    }
    lines.push_back(std::move(line));
  }
}

void add_truths(const KnownCollision& known, std::vector<KnownLine>& lines) {
  const ExactCase exact_case(known.collision);
  KnownLine matrix{known.name + ", collision matrix", {}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      matrix.numbers.push_back(to_double(exact_case.collision_matrix()(i, j)));
    }
  }
  for (const double allowance : allowances) {
    matrix.numbers.push_back(exact_case.collision_matrix_sensitivity(allowance));
  }
  lines.push_back(std::move(matrix));
  const auto add_outcome = [&](const std::string& name, const Outcome<double>& outcome) {
    KnownLine line{known.name + ", " + name, {}};
    for (const Vector3<double>* vector : vectors(outcome)) {
      line.numbers.insert(line.numbers.end(), vector->begin(), vector->end());
    }
    lines.push_back(std::move(line));
  };
  for (const Law law : laws_with_truth) {
    add_outcome("outcome of " + std::string(name_of(law)), exact_case.nearest_truth(law));
  }
  for (const CoulombAnswer& answer : coulomb_answers(exact_case)) {
    add_outcome("outcome of coulomb, " + std::string(name_of(answer.kind)),
                map_outcome<double>(answer.truth.outcome, [](const Rational& x) { return nearest_double(x); }));
  }
}

TEST(KnownValues, OfTheJudge) {
  std::vector<KnownLine> lines;
  for (const KnownCollision& known : unit::known_collisions()) {
    add_truths(known, lines);
    add_bounds(known, lines);
    add_facts(known, lines);
    add_underflow(known, lines);
    for (const double allowance : allowances) {
      add_comparisons(known, allowance, lines);
      add_accuracies(known, allowance, lines);
    }
  }
  unit::expect_known_lines(CAROM_KNOWN_VALUES, lines);
}

}  // namespace
}  // namespace carom::oracles
