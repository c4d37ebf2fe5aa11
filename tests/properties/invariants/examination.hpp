// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

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

}  // namespace carom::properties
