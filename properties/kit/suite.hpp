// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <vector>

#include <carom/properties/kit/statement.hpp>

namespace carom::conformance {

/// Registers the GoogleTest tests of the statements that `make` returns: the suite NAME/Conformance, at this place in
/// the source. If `make` throws, the suite has only the test Holds/options, which fails and gives the reason. Returns
/// true, so that a variable can call it before main. suite.cpp defines it. Every test program compiles suite.cpp, and a
/// program that does not call this function has no test of it.
bool add_suite(const char* name, const char* file, int line, const std::function<std::vector<Statement>()>& make);

}  // namespace carom::conformance
