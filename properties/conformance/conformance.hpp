// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/conformance/subject.hpp>
#include <carom/properties/conformance/suite.hpp>

/// Instantiates the suite NAME/Conformance of a subject in GoogleTest. It has one test Holds/INVARIANT_in_FAMILY for
/// each family and each invariant that is claimed for the subject's law. RapidCheck draws the cases.
///
///     CAROM_CONFORMANCE(MySolver, carom::conformance::subject("my solver", carom::Law::frictionless, my_callable));
///
/// A further argument gives carom::conformance::Options. If an option, or CAROM_EXACT in the environment, is wrong, the
/// suite is one test that fails and gives the reason. RapidCheck's RC_PARAMS sets the seed and the number of cases. A
/// test is skipped if no case is in the domain of its invariant. A callable is not judged by `invalid_refused`, because
/// the kit refuses invalid collisions for it. The invariants of the collision matrix are judged only if the callable
/// returns the matrix, in SolvedOutcome<S>.
#define CAROM_CONFORMANCE(NAME, ...)                                                                               \
  using ::carom::conformance::Conformance;                                                                         \
  INSTANTIATE_TEST_SUITE_P(NAME, Conformance,                                                                      \
                           ::testing::ValuesIn(::carom::conformance::suite(                                        \
                               __FILE__, __LINE__, [] { return ::carom::conformance::statements(__VA_ARGS__); })), \
                           ::carom::conformance::test_name)
