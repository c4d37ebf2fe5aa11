// SPDX-License-Identifier: BSL-1.0
#include <span>
#include <variant>

#include <gtest/gtest.h>

#include <carom/oracles/judge/exact_case.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

/// If a built-in solver reports its matrix at all, it reports the matrix in every colliding case.
TEST(ShownMatrix, IsThatOfTheSolve) {
  for (const Subject& subject : subjects::built_in_subjects()) {
    int shown = 0;
    int changed = 0;
    Session session = subject.open();
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Collision collision = unit::case_of("sliding", i).collision;
      shown += std::get<ReportedOutcome>(session(std::span(&collision, 1)).at(0)).collision_matrix ? 1 : 0;
      changed += oracles::ExactCase(collision).approach() == oracles::Approach::colliding ? 1 : 0;
    }
    EXPECT_GT(changed, 5);
    EXPECT_EQ(shown, subject.shows_collision_matrix ? changed : 0) << subject.name;
    const bool forms_none = subject.law == Law::frictionless || subject.name.find("-batch-") != std::string::npos;
    EXPECT_EQ(subject.shows_collision_matrix, !forms_none) << subject.name;
  }
}

/// Without friction, `coulomb` needs no matrix. It shows the matrix all the same, because it claims so.
TEST(ShownMatrix, IsShownWhereTheSolveNeedsNone) {
  const Subject subject = *subjects::subject_named("coulomb-double");
  Case one = unit::case_of("sliding", 0);
  Session session = subject.open();
  for (const double friction : {0.5, 0.0}) {
    one.collision.friction = friction;
    EXPECT_TRUE(std::get<ReportedOutcome>(session(std::span(&one.collision, 1)).at(0)).collision_matrix.has_value());
  }
}

}  // namespace
}  // namespace carom::properties
