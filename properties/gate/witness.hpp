// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

/// The most serious violation of the invariant, as it was found, in the family that violates it most often.
/// Precondition: `result.count(invariant).violated` > 0.
[[nodiscard]] Witness found_witness(const SubjectResult& result, const GateOptions& options,
                                    const Invariant& invariant);

/// The witness on the simplest collision that shrinking finds within the domain, judged exactly. Throws the exceptions
/// of the subject's session.
[[nodiscard]] Witness shrunk_witness(const Subject& subject, const Claim& claim, Witness witness, const Domain& within);

/// Gives each result a witness of each violated invariant. If options.shrinks, the witness of a subject that is
/// explained is shrunk. A stop that options.stop requests ends the shrinking. If the shrinking fails, the witness stays
/// as it was found. Preconditions: the results have no witnesses, and their subjects open sessions.
void add_witnesses(GateReport& report);

/// Whether `verdict` is about as serious a violation as `found`, and of the same kind.
[[nodiscard]] bool is_as_bad(const Verdict& verdict, const Collision& collision, const Verdict& found,
                             const Collision& found_on);

/// Shrinks `one` to a simple case of the kinds that violates the invariant about as seriously. `found` is the verdict
/// on `one`. Returns `one` if it is invalid, or if the invariant rests on shapes.
[[nodiscard]] Case simplest_violation(const Case& one, const Invariant& invariant, const Verdict& found,
                                      const std::function<Verdict(const Case&)>& verdict_on, std::size_t most_calls,
                                      const Kinds& kinds = {});

struct AnswerAndJudgement {
  Answer answer;
  Judgement judgement;
};

/// The answer to one case in this session of a subject, judged. Throws SessionFailure or SubjectError if the session
/// throws, and JudgeError if the judge fails.
[[nodiscard]] AnswerAndJudgement judge_in_session(const Claim& claim, Session& session, const Case& one);

/// Judges one case in a new session of the subject.
[[nodiscard]] AnswerAndJudgement judge_one(const Subject& subject, const Claim& claim, const Case& one);

}  // namespace carom::properties
