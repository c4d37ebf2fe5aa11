// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/oracles/judge/yardstick.hpp>

namespace carom::conformance {

struct Options {
  double limit_ulps = oracles::default_limit_ulps;  // in units in the last place of the subject's precision
  std::vector<std::string> families = {};           // names; empty for all families
  std::vector<std::string> deviates = {};  // "invariant" or "invariant@family" to leave out, besides Subject::deviates
  /// Whether exact arithmetic alone judges, without filters. CAROM_EXACT in the environment overrides this option.
  bool exact = false;
};

}  // namespace carom::conformance
