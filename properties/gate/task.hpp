// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include <carom/properties/gate/schedule.hpp>
#include <carom/properties/gate/subject_tally.hpp>

/// The judging of one subject on some cases.
namespace carom::properties {

/// A case, and the subject's answer.
struct Asked {
  std::size_t family;
  std::uint64_t index;
  Case one;
  Answer answer;
};

/// The violation that ended a subject's run, if runs end at the first violation.
struct FirstViolation {
  std::uint64_t task = 0;  // number of the task
  Asked asked;
  Judgement judgement;         // its last verdict is the violation
  bool is_of_new_case = true;  // false if the case was judged before and asked again

  void add_to(SubjectTally& tally, const Claim& claim) const;
};

/// A subject in one thread.
struct Examinee {
  const Subject& subject;
  const Claim& claim;
  const std::vector<const Family*>& families;  // the families of the options
  Session& session;
  std::uint64_t relations_every;
  bool ends_at_first;                                  // the run of the subject ends at its first violation
  std::vector<Asked> remembered = {};                  // to be asked again in a separate session
  std::optional<FirstViolation> first_violation = {};  // not in any tally
};

/// Whether a case is asked again in the same session, and whether it is asked again in a separate session. Both answers
/// depend on the case alone, so that results do not depend on tasks or threads.
[[nodiscard]] bool is_asked_again(std::uint64_t index);
[[nodiscard]] bool is_remembered(std::uint64_t index, std::size_t families);

/// Puts the cases of one task to one subject: first all cases, then all questions that their answers raise. If the
/// session fails, the answers so far are judged without the invariants that ask further questions, and the failure is
/// thrown. If the run ends at the first violation, the function sets `first_violation` and judges nothing after it.
void judge_task(Examinee& examinee, const Task& task, const std::deque<JudgedCase>& cases, SubjectTally& tally);

/// Asks an invalid collision, then the cases again, the last ones first. Judges whether the answers are the same.
void ask_again(Examinee& examinee, std::uint64_t task, Session& session, const std::vector<Asked>& asked,
               SubjectTally& tally);

}  // namespace carom::properties
