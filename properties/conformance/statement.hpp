// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/properties/conformance/options.hpp>

// Users compile this: what judges is declared, and not included.
namespace carom::properties {
struct Claim;
struct Family;
struct Invariant;
}  // namespace carom::properties

namespace carom::conformance {

/// What one test tests: that an invariant holds of a subject in the cases of a family.
struct Statement {
  std::shared_ptr<const Subject> subject;
  const properties::Invariant* invariant;
  const properties::Family* family;
  oracles::Yardstick yardstick;
  const char* file = "";  // where the suite stands
  int line = 0;
  std::string error = {};  // why there is no suite; the fields above but for the place then stand for nothing

  /// The claim of the one invariant.
  [[nodiscard]] properties::Claim claim() const;
};

/// Every statement of a suite: the invariants that are claimed, by all families. Left out are the invariants about the
/// collision matrix where the subject shows none, and the family of invalid collisions where `invalid_refused` is not
/// claimed. Throws std::invalid_argument where an option names what there is not, or where CAROM_EXACT is neither 0
/// nor 1.
[[nodiscard]] std::vector<Statement> statements(const Subject& subject, const Options& options = {});

/// "restitution_in_near_head_on"; "options" where there is an error.
[[nodiscard]] std::string name_of(const Statement& statement);

/// How GoogleTest prints it.
void PrintTo(const Statement& statement, std::ostream* out);

}  // namespace carom::conformance
