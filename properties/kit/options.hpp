// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <optional>
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
  /// The domain into which the cases are drawn: "games", or another text that `properties::domain_from` reads. Empty
  /// for Subject::domain.
  std::string within = {};
  std::optional<int> digits = {};  // permits a relative error of 10^-digits, in place of limit_ulps
  /// Changes of the law's answer that the subject makes on purpose, besides Subject::effects. The names are those of
  /// the protocol: {{"restitution_threshold", 0.5}}.
  std::map<std::string, double> effects = {};
};

}  // namespace carom::conformance
