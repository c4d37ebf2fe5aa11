// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include <carom/properties/gate/schedule.hpp>
#include <carom/properties/gate/subject_tally.hpp>

namespace carom::properties {

struct Asked {
  std::size_t family;
  std::uint64_t index;
  Case one;
  Answer answer;
};

/// The violation that ended a subject's run.
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

/// Whether the gate asks the case again in the same session. Only the number of the case decides, so results do not
/// depend on tasks or threads.
[[nodiscard]] bool is_asked_again(std::uint64_t index);
/// Whether the gate asks the case again in a separate session.
[[nodiscard]] bool is_remembered(std::uint64_t index, std::size_t families);

/// Asks a subject the cases of one task, then the questions of the relations. If the session fails, judges the answers
/// so far without relations, and rethrows. If the run ends at the first violation, sets `first_violation` and stops
/// there.
void judge_task(Examinee& examinee, const Task& task, const std::deque<JudgedCase>& of_every_subject,
                SubjectTally& tally);

/// Asks an invalid collision, then the cases again, from the last to the first. Judges whether the answers are the same
/// as before.
void ask_again(Examinee& examinee, std::uint64_t task, Session& session, const std::vector<Asked>& asked,
               SubjectTally& tally);

}  // namespace carom::properties
