// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/oracles/judge/yardstick.hpp>

namespace carom::conformance {

/// What a suite may choose.
struct Options {
  double limit_ulps = oracles::default_limit_ulps;  // of the subject's precision
  std::vector<std::string> families = {};           // their names; empty for all
  std::vector<std::string> deviates = {};  // "invariant" or "invariant@family" to leave out, besides Subject::deviates
  bool exact = false;  // judge in exact arithmetic alone, without the filter; the environment's CAROM_EXACT comes first
};

}  // namespace carom::conformance
