// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/properties/cases/choices.hpp>
#include <carom/properties/cases/domain.hpp>

// Declared here, because users compile this header without the judge.
namespace carom::properties {
struct Claim;
struct Invariant;
}  // namespace carom::properties

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

/// The common part of a suite's tests.
struct Suite {
  Subject subject;               // with the deviations and effects of the options
  properties::Domain within;     // the cases are drawn into it
  oracles::Yardstick yardstick;  // of the subject's precision
  std::vector<const properties::Family*> families;

  // Findings of the tests of this process so far.
  std::set<const properties::Invariant*> judged = {};  // on at least one case
  std::optional<std::string> ended = {};               // why and in which test the subject ended; it is not asked again
  std::optional<std::string> diagnosed_in = {};        // the test whose message has the diagnosis
};

/// The claim that an invariant holds for a subject in the cases of a family.
struct Statement {
  std::shared_ptr<Suite> suite;
  const properties::Invariant* invariant;
  const properties::Family* family;

  [[nodiscard]] properties::Claim claim() const;
};

/// All statements of a suite: each claimed invariant in each family. Leaves out the family `invalid` if the subject
/// does not claim `invalid_refused`, and families without a case in the domain. Throws std::invalid_argument if an
/// option is wrong, if Subject::domain is, or if CAROM_EXACT is neither 0 nor 1.
[[nodiscard]] std::vector<Statement> statements(const Subject& subject, const Options& options = {});

/// Draws a case of the statement's family into the suite's domain. The domain may not contain a case with simple
/// numbers.
[[nodiscard]] properties::Draw draw_of(const Statement& statement);

/// For example "restitution_in_near_head_on".
[[nodiscard]] std::string name_of(const Statement& statement);

/// "restitution of my solver in near_head_on".
[[nodiscard]] std::string in_words(const Statement& statement);

}  // namespace carom::conformance
