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

/// What one test says of one case.
using Question = std::function<Verdict(const Examinee&, const JudgedCase&)>;

/// The verdict of one invariant of the catalogue; skipped on the cases that it does not speak of.
[[nodiscard]] Question invariant_holds(const Invariant& invariant);

struct Examination {
  std::uint64_t cases = 0;  // of each family
  /// Whether `structured` is among the families: its sizes underflow in binary32 on the way, where a question about
  /// bits has nothing to ask.
  bool structured = true;
  std::span<const Family> families = all_families();
};

/// Puts a question about cases of every family, and about one plain head-on collision, to an examinee. Returns what
/// speaks against it: a case on which the verdict is a violation; or that no case of a family was in the question's
/// domain; or that the examinee answered no colliding one with other velocities than before, so that nothing was
/// tested. The head-on collision counts for neither: families that draw nothing are noticed.
[[nodiscard]] std::optional<std::string> find_violation(const Examinee& examinee, const Question& question,
                                                        const Examination& examination);

/// An examinee, and the invariants that are asked about it.
struct Claimant {
  Examinee examinee;
  std::vector<const Invariant*> invariants;
};

/// The results of a claimant's cases.
struct Seen {
  bool responded = false;  // a colliding case of a family was answered with other velocities than before
  std::set<const Invariant*> in_domain = {};  // these held in some case of a family
  std::set<const Invariant*> violated = {};   // these did not hold in some case; they are not asked again
};

/// Draws the cases of `find_violation` once, and puts each to all claimants. In the claimants' order.
[[nodiscard]] std::vector<Seen> examine(std::span<const Claimant> claimants, const Examination& examination);

/// The return value of `find_violation` for one of the invariants of a claimant, if `examine` saw this of it. The cases
/// are drawn again to shrink a violation.
[[nodiscard]] std::optional<std::string> found_by(const Seen& seen, const Claimant& claimant,
                                                  const Invariant& invariant, const Examination& examination);

}  // namespace carom::properties
