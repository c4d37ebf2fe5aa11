// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/kit/subject.hpp>
#include <carom/properties/kit/suite.hpp>

/// Adds the GoogleTest suite NAME/Conformance of a subject (subject.hpp). The suite has a test
/// Holds/INVARIANT_in_FAMILY for each family and each invariant that the subject claims. RapidCheck draws the cases;
/// RC_PARAMS sets the seed and the number of cases.
///
///     CAROM_CONFORMANCE(MySolver, carom::conformance::subject("my solver", carom::Law::frictionless, my_callable));
///
/// A further argument gives carom::conformance::Options. The arguments are evaluated before main, after the variables
/// above in the same file. If an option, or CAROM_EXACT in the environment, is wrong, the suite has only one test,
/// which fails and gives the reason. A test is skipped if no case is in the domain of its invariant.
#define CAROM_CONFORMANCE(NAME, ...)                                                             \
  [[maybe_unused]] static const bool carom_conformance_##NAME = ::carom::conformance::add_suite( \
      #NAME, __FILE__, __LINE__, [] { return ::carom::conformance::statements(__VA_ARGS__); })
