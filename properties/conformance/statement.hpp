// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/properties/conformance/options.hpp>

// Declared here, because users compile this header without the judge.
namespace carom::properties {
struct Claim;
struct Family;
struct Invariant;
}  // namespace carom::properties

namespace carom::conformance {

/// The claim that an invariant holds for a subject in the cases of a family.
struct Statement {
  std::shared_ptr<const Subject> subject;
  const properties::Invariant* invariant;
  const properties::Family* family;
  oracles::Yardstick yardstick;
  const char* file = "";  // of the suite
  int line = 0;
  std::string error = {};  // why there is no suite; if set, the other fields except `file` and `line` have no meaning

  [[nodiscard]] properties::Claim claim() const;
};

/// All statements of a suite: each claimed invariant in each family. Leaves out the family `invalid` if the subject
/// does not claim `invalid_refused`. Throws std::invalid_argument if an option names an unknown family, invariant or
/// deviation, or if CAROM_EXACT is neither 0 nor 1.
[[nodiscard]] std::vector<Statement> statements(const Subject& subject, const Options& options = {});

/// For example "restitution_in_near_head_on"; "options" if the statement has an error.
[[nodiscard]] std::string name_of(const Statement& statement);

void PrintTo(const Statement& statement, std::ostream* out);

}  // namespace carom::conformance
