// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <carom/properties/families/family.hpp>

#include "examinee.hpp"

namespace carom::properties {

/// The verdict of one test on one case.
using Question = std::function<Verdict(const Examinee&, const JudgedCase&)>;

/// The verdict of one invariant of the catalogue. It is skipped on cases outside the invariant's domain.
[[nodiscard]] Question invariant_holds(const Invariant& invariant);

struct Examination {
  std::uint64_t cases = 0;  // for each family
  /// Whether `structured` is among the families. Its sizes underflow in binary32, which makes questions about bits
  /// meaningless.
  bool structured = true;
  std::span<const Family> families = all_families();
};

/// Puts a question about cases of every family, and about one plain head-on collision, to an examinee. Returns the
/// objection to the examinee. One objection is a case on which the verdict is a violation. Another is that no case of
/// a family is in the question's domain. The last is that no answer to a colliding case changes the velocities, so
/// that nothing is tested. The head-on collision counts for neither of the last two, so families that draw nothing
/// are noticed.
[[nodiscard]] std::optional<std::string> find_violation(const Examinee& examinee, const Question& question,
                                                        const Examination& examination);

/// An examinee, and the invariants to test on it.
struct Claimant {
  Examinee examinee;
  std::vector<const Invariant*> invariants;
};

/// The results of a claimant's cases.
struct Seen {
  bool responded = false;                     // in a colliding case of a family, the answer changed the velocities
  std::set<const Invariant*> in_domain = {};  // these held in some case of a family
  std::set<const Invariant*> violated = {};   // these were violated in some case, and are not tested again
};

/// Draws the cases of `find_violation` once, and puts each to all claimants. The results are in the claimants' order.
[[nodiscard]] std::vector<Seen> examine(std::span<const Claimant> claimants, const Examination& examination);

/// The return value of `find_violation` for one invariant of a claimant, given the results of `examine`. The cases
/// are drawn again to shrink a violation.
[[nodiscard]] std::optional<std::string> found_by(const Seen& seen, const Claimant& claimant,
                                                  const Invariant& invariant, const Examination& examination);

}  // namespace carom::properties
