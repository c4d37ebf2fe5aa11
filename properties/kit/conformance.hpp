// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <vector>

#include <carom/properties/kit/statement.hpp>
#include <carom/properties/kit/subject.hpp>

namespace carom::conformance {

/// Registers the GoogleTest tests of the statements that `make` returns: the suite NAME/Conformance, at this place in
/// the source. If `make` throws, the suite has only the test Holds/options, which fails and gives the reason. Returns
/// true, so that a variable can call it before main. suite.cpp defines it. Every test program compiles suite.cpp, and a
/// program that does not call this function has no test of it.
bool add_suite(const char* name, const char* file, int line, const std::function<std::vector<Statement>()>& make);

}  // namespace carom::conformance

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
