// SPDX-License-Identifier: GPL-3.0-or-later
#include "rejection.hpp"

#include <vector>

namespace carom::mutants {

std::set<std::string_view> rejecting_invariants(const Subject& subject, std::span<const properties::Family> families,
                                                std::uint64_t seed, std::uint64_t cases) {
  properties::Claim claim = properties::claim_of(subject, {});
  std::set<std::string_view> rejecting;
  Session session = subject.open();
  const auto solve = [&](const Collision& collision) {
    return properties::lift(session(std::span(&collision, 1)).at(0));
  };
  for (const properties::Family& family : families) {
    for (std::uint64_t index = 0; index < cases; ++index) {
      properties::Stream stream = properties::case_stream(seed, family.name, index);
      const properties::JudgedCase judged_case(family.generate(stream));
      const properties::Judgement judgement =
          properties::try_case(judged_case, claim, solve, properties::shown_collision_matrix(subject, judged_case));
      for (const properties::NamedVerdict& named : judgement.verdicts) {
        if (named.verdict.status == properties::Status::violated) {
          rejecting.insert(named.invariant->name);
        }
      }
      std::erase_if(claim.invariants,
                    [&](const properties::Invariant* invariant) { return rejecting.contains(invariant->name); });
    }
  }
  return rejecting;
}

}  // namespace carom::mutants
