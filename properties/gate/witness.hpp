// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <carom/properties/gate/gate_result.hpp>

/// Violations that can be replayed.
namespace carom::properties {

/// The worst violation of the invariant, as it was found. Precondition: the subject violated it.
[[nodiscard]] Witness found_witness(const SubjectResult& result, const GateOptions& options,
                                    const std::string& invariant);

/// The same on the simplest collision that can be found, worked out in exact arithmetic, the truth certified. Throws
/// what the subject's session throws.
[[nodiscard]] Witness shrunk_witness(const Subject& subject, const Claim& claim, Witness witness);

/// Whether a violation is about as bad as the one that was found, of the same invariant.
[[nodiscard]] bool is_as_bad(const Verdict& verdict, const Collision& collision, const Verdict& found,
                             const Collision& found_on);

/// The simplest case that can be found that violates the invariant about as badly as `found`, the verdict on `one`.
[[nodiscard]] Case simplest_violation(const Case& one, const Invariant& invariant, const Verdict& found,
                                      const std::function<Verdict(const Case&)>& verdict_on, std::size_t most_calls);

struct AnswerAndJudgement {
  Answer answer;
  Judgement judgement;
};

/// A subject's answer to one collision, judged. Throws where the subject cannot be judged.
/// Precondition: the session is one of the subject's.
[[nodiscard]] AnswerAndJudgement judge_in_session(const Claim& claim, Session& session, const Case& one);

/// The same by a session of its own, which is then closed.
[[nodiscard]] AnswerAndJudgement judge_one(const Subject& subject, const Claim& claim, const Case& one);

}  // namespace carom::properties
