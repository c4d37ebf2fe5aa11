// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/changed_subject.hpp"

namespace carom::properties::diagnosis {
namespace {

Diagnosis diagnosis_of(const Subject& subject, GateOptions options) {
  options.shrinks = false;
  return diagnose_all(run_gate({subject}, options)).at(0);
}

TEST(Diagnosis, OfASingleViolatedCaseSaysThatItIsTooFewForAHint) {
  GateOptions options = unit::gate_options(default_cases, {"structured", "near_head_on"});
  options.fail_fast = true;
  const Diagnosis diagnosis = diagnosis_of(unit::subject_of("reflection-in-basis-double"), options);
  EXPECT_EQ(diagnosis.violated, 1U);
  ASSERT_EQ(diagnosis.faults.size(), 1U);
  EXPECT_EQ(
      diagnosis.faults[0].what,
      "Only 1 violated case was examined, and a hint on the cause needs 5. Judge more cases without --fail-fast.");
  EXPECT_EQ(diagnosis.faults[0].where, "");
  EXPECT_EQ(diagnosis.faults[0].look_at, "");
}

/// A subject that a run does not explain has the same violations. Their witnesses stay as they were found.
TEST(Diagnosis, IsLeftOutForASubjectThatTheRunDoesNotExplain) {
  GateOptions options = unit::gate_options(100, {"near_head_on"});
  options.explains = {true, false};
  const Subject subject = unit::subject_of("reflection-in-basis-double");
  const GateReport report = run_gate({subject, subject}, options);
  const std::vector<Diagnosis> diagnoses = diagnose_all(report);
  EXPECT_FALSE(diagnoses.at(0).faults.empty());
  EXPECT_TRUE(diagnoses.at(1).faults.empty());
  const std::vector<Witness>& explained = report.results.at(0).witnesses;
  const std::vector<Witness>& found = report.results.at(1).witnesses;
  ASSERT_EQ(explained.size(), found.size());
  ASSERT_FALSE(found.empty());
  const auto is_as_found = [](const Witness& witness) {
    return witness.shrunk.collision.a.velocity == witness.original.collision.a.velocity;
  };
  EXPECT_TRUE(std::all_of(found.begin(), found.end(), is_as_found));
  EXPECT_FALSE(std::all_of(explained.begin(), explained.end(), is_as_found));
}

/// `frictionless-world-double` keeps the inverse inertia as a matrix in world axes. The diagnosis must name this
/// matrix, although features of `structured` might also distinguish the violated cases.
TEST(Diagnosis, OfSlenderBodiesNamesTheInverseInertiaInWorldAxes) {
  const Diagnosis slender =
      diagnosis_of(unit::subject_of("frictionless-world-double"), unit::gate_options(200, {"physical", "structured"}));
  EXPECT_NE(slender.faults.at(0).where.find("if a body's greatest moment over its least is at least "),
            std::string::npos)
      << slender.faults.at(0).where;
  EXPECT_TRUE(slender.faults.at(0).look_at.starts_with("the inverse inertia: J⁻¹ as a matrix in world axes "))
      << slender.faults.at(0).look_at;
  const Diagnosis others = diagnosis_of(unit::subject_of("reflection-in-basis-double"),
                                        unit::gate_options(200, {"near_head_on", "head_on"}));
  EXPECT_EQ(others.faults.at(0).look_at.find("world axes"), std::string::npos) << others.faults.at(0).look_at;
}

/// The subject, with the numbers of its answers changed.
Subject changed(const char* name, double (*change)(double)) {
  return unit::with_outcomes(unit::subject_of(name), [change](const Collision&, ReportedOutcome& outcome) {
    static_cast<Outcome<long double>&>(outcome) = map_outcome<long double>(
        outcome, [&](long double x) { return static_cast<long double>(change(static_cast<double>(x))); });
  });
}

TEST(Diagnosis, OfBinary32InDoublesNamesThePrecision) {
  const auto fault = [](double (*change)(double)) {
    const GateOptions options = unit::gate_options(100, {"generic", "head_on"});
    return diagnosis_of(changed("frictionless-double", change), options).faults.at(0);
  };
  const Fault narrow = fault([](double x) { return static_cast<double>(static_cast<float>(x)); });
  EXPECT_TRUE(
      narrow.what.ends_with("answers fits binary32, but it claims binary64: it computes or stores velocities in "
                            "single precision."))
      << narrow.what;
  // Numbers of few digits tell nothing.
  for (const auto change : {+[](double) { return 0.0; }, +[](double x) { return std::nearbyint(x); }}) {
    EXPECT_EQ(fault(change).what.find("binary32"), std::string::npos) << fault(change).what;
  }
}

/// The subject changes A's spin by 5 % too much if A's greatest moment exceeds 3 times the least. This error loses no
/// digits.
TEST(Diagnosis, OfAWrongFormulaForSomeInertiasDoesNotNameLostDigits) {
  const Subject subject = unit::with_outcomes(
      unit::subject_of("frictionless-double"), [](const Collision& collision, ReportedOutcome& outcome) {
        const Body& a = collision.a;
        if (a.principal_inertia.maxCoeff() > 3 * a.principal_inertia.minCoeff()) {
          outcome.a.angular_velocity += 0.05L * (outcome.a.angular_velocity - a.angular_velocity.cast<long double>());
        }
      });
  const Diagnosis diagnosis = diagnosis_of(subject, unit::gate_options(200, {"physical"}));
  EXPECT_NE(diagnosis.faults.at(0).where.find("greatest moment over its least is at least "), std::string::npos)
      << diagnosis.faults.at(0).where;
  EXPECT_EQ(diagnosis.faults.at(0).look_at.find("world axes"), std::string::npos) << diagnosis.faults.at(0).look_at;
}

Subject inelastic(Subject subject) {
  return unit::misreading(std::move(subject), [](Collision& collision) { collision.restitution = 0; });
}

/// Most collisions have one answer under the law `coulomb`, so hypotheses explain it.
TEST(Diagnosis, OfAnInelasticSolverWithFrictionNamesTheRestitution) {
  const Subject subject = inelastic(unit::subject_of("coulomb-double"));
  const Diagnosis diagnosis = diagnosis_of(subject, unit::gate_options(50, {"generic", "sliding"}));
  ASSERT_EQ(diagnosis.faults.size(), 1U) << diagnosis.faults.back().what;
  EXPECT_EQ(diagnosis.faults[0].what, "It answers as if ε were 0.");
}

TEST(Diagnosis, OfAWrongImpulseOfAnyLawNamesTheRestitution) {
  Subject subject = unit::subject_of("frictionless-double");
  subject.law = Law::any;
  const Diagnosis diagnosis = diagnosis_of(inelastic(subject), unit::gate_options(50, {"generic", "sliding"}));
  EXPECT_NE(diagnosis.faults.at(0).what.find("The normal velocity after the impulse is not −ε N·V⁻"), std::string::npos)
      << diagnosis.faults.at(0).what;
}

}  // namespace
}  // namespace carom::properties::diagnosis
