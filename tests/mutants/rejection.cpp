// SPDX-License-Identifier: BSL-1.0
#include "rejection.hpp"

#include <utility>

namespace carom::mutants {
namespace {

struct Accused {
  properties::Claim claim;
  properties::Sameness sameness;
  Session session;
  Rejecting rejecting = {};
  std::vector<std::pair<Collision, Answer>> asked = {};

  [[nodiscard]] Answer ask(const Collision& collision) { return session(std::span(&collision, 1)).at(0); }
};

void judge(Accused& accused, const properties::JudgedCase& judged_case, bool is_asked_again) {
  const auto solve = [&](const Collision& collision) {
    const Answer answer = accused.ask(collision);
    if (std::exchange(is_asked_again, false)) {
      accused.asked.emplace_back(collision, answer);
    }
    return properties::lift(answer);
  };
  for (const properties::NamedVerdict& named : try_case(judged_case, accused.claim, solve).verdicts) {
    if (named.verdict.status == properties::Status::violated) {
      accused.rejecting.insert(named.invariant->name);
    }
  }
  std::erase_if(accused.claim.invariants,
                [&](const properties::Invariant* invariant) { return accused.rejecting.contains(invariant->name); });
}

void ask_again(Accused& accused) {
  for (const properties::Invariant* invariant : accused.claim.invariants) {
    const auto* about = std::get_if<properties::AboutSession>(&invariant->about);
    if (about == nullptr) {
      continue;
    }
    for (const auto& [collision, answer] : accused.asked) {
      if (about->check(answer, accused.ask(collision), accused.sameness).status == properties::Status::violated) {
        accused.rejecting.insert(invariant->name);
      }
    }
  }
}

}  // namespace

std::vector<Rejecting> rejecting_invariants(std::span<const Subject> subjects,
                                            std::span<const properties::Family> families, std::uint64_t seed,
                                            std::uint64_t cases) {
  constexpr std::uint64_t asked_again_every = 10;
  std::vector<Accused> all;
  for (const Subject& subject : subjects) {
    all.push_back({properties::claim_of(subject, {}), properties::sameness_of_answers(subject), subject.open()});
  }
  for (const properties::Family& family : families) {
    for (std::uint64_t index = 0; index < cases * static_cast<std::uint64_t>(family.weight); ++index) {
      const properties::JudgedCase judged_case(properties::drawn_case(family, seed, index));
      for (Accused& accused : all) {
        judge(accused, judged_case, index % asked_again_every == 0);
      }
    }
  }
  std::vector<Rejecting> rejecting;
  for (Accused& accused : all) {
    ask_again(accused);
    rejecting.push_back(std::move(accused.rejecting));
  }
  return rejecting;
}

}  // namespace carom::mutants
