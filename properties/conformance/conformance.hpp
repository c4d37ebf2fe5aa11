// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/conformance/subject.hpp>
#include <carom/properties/conformance/suite.hpp>

/// Instantiates the suite NAME/Conformance of a subject: one test Holds/INVARIANT_in_FAMILY for each invariant that is
/// claimed for its model and each family, in GoogleTest, with cases that RapidCheck draws.
///
///     CAROM_CONFORMANCE(MySolver, carom::conformance::subject("my solver", carom::Model::frictionless, my_callable));
///
/// A further argument gives carom::conformance::Options; where one is wrong, or CAROM_EXACT in the environment, the
/// suite is one test that fails and says so. RapidCheck's RC_PARAMS sets the seed and the number of cases. A test is
/// skipped if no case is in the domain of its invariant. Two things are not judged of callables: `invalid_refused`,
/// because the kit refuses invalid collisions for them, and the invariants of the collision matrix, unless they return
/// it as SolvedOutcome<S>.
#define CAROM_CONFORMANCE(NAME, ...)                                                                               \
  using ::carom::conformance::Conformance;                                                                         \
  INSTANTIATE_TEST_SUITE_P(NAME, Conformance,                                                                      \
                           ::testing::ValuesIn(::carom::conformance::suite(                                        \
                               __FILE__, __LINE__, [] { return ::carom::conformance::statements(__VA_ARGS__); })), \
                           ::carom::conformance::test_name)
