// SPDX-License-Identifier: BSL-1.0
#include "rejection.hpp"

#include <utility>
#include <vector>

namespace carom::mutants {

std::set<std::string_view> rejecting_invariants(const Subject& subject, std::span<const properties::Family> families,
                                                std::uint64_t seed, std::uint64_t cases) {
  constexpr std::uint64_t asked_again_every = 10;
  properties::Claim claim = properties::claim_of(subject, {});
  std::set<std::string_view> rejecting;
  Session session = subject.open();
  const auto ask = [&](const Collision& collision) { return session(std::span(&collision, 1)).at(0); };
  std::vector<std::pair<Collision, Answer>> asked;
  for (const properties::Family& family : families) {
    for (std::uint64_t index = 0; index < cases * static_cast<std::uint64_t>(family.weight); ++index) {
      const properties::JudgedCase judged_case(properties::drawn_case(family, seed, index));
      bool is_first = index % asked_again_every == 0;
      const auto solve = [&](const Collision& collision) {
        const Answer answer = ask(collision);
        if (std::exchange(is_first, false)) {
          asked.emplace_back(collision, answer);
        }
        return properties::lift(answer);
      };
      const properties::Judgement judgement = properties::try_case(judged_case, claim, solve);
      for (const properties::NamedVerdict& named : judgement.verdicts) {
        if (named.verdict.status == properties::Status::violated) {
          rejecting.insert(named.invariant->name);
        }
      }
      std::erase_if(claim.invariants,
                    [&](const properties::Invariant* invariant) { return rejecting.contains(invariant->name); });
    }
  }
  for (const properties::Invariant* invariant : claim.invariants) {
    if (const auto* about = std::get_if<properties::AboutSession>(&invariant->about)) {
      for (const auto& [collision, answer] : asked) {
        if (about->check(answer, ask(collision), properties::sameness_of_answers(subject)).status ==
            properties::Status::violated) {
          rejecting.insert(invariant->name);
        }
      }
    }
  }
  return rejecting;
}

}  // namespace carom::mutants
