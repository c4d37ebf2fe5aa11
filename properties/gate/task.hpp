// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include <carom/properties/gate/schedule.hpp>
#include <carom/properties/gate/tally.hpp>

/// What is done with one subject on some cases.
namespace carom::properties {

/// A case, and what was answered to it.
struct Asked {
  std::size_t family;
  std::uint64_t index;
  Case one;
  Answer answer;
};

/// The violation that ended a subject's run, where it ends at the first.
struct FirstViolation {
  std::uint64_t task = 0;  // its number
  Asked asked;
  Judgement judgement;         // its last verdict is the one violated
  bool is_of_new_case = true;  // else of a case that was judged before, and asked again

  void add_to(Tally& tally, const Claim& claim) const;
};

/// A subject as one thread asks it.
struct Examinee {
  const Subject& subject;
  const Claim& claim;
  const std::vector<const Family*>& families;  // of the options
  Session& session;
  std::uint64_t relations_every;
  bool ends_at_first;                                  // violation
  std::vector<Asked> remembered = {};                  // to be asked again in a session of their own
  std::optional<FirstViolation> first_violation = {};  // in none of the tallies
};

/// Whether a case is asked again in the session, and whether in a session of its own. Both are a matter of the case
/// alone, so that what is judged depends neither on tasks nor on threads.
[[nodiscard]] bool is_asked_again(std::uint64_t index);
[[nodiscard]] bool is_remembered(std::uint64_t index, std::size_t families);

/// Puts the cases of one task to one subject: first all cases, then all questions that their answers raise. Where the
/// session fails, what it had answered is judged, the invariants that ask further questions left out, and the failure
/// thrown. Where the run ends at the first violation, `first_violation` is set by it, and nothing after it is judged.
void judge_task(Examinee& examinee, const Task& task, const std::deque<JudgedCase>& cases, Tally& tally);

/// Asks cases again, the last ones first, after an invalid one, and judges whether the answers are the same.
void ask_again(Examinee& examinee, std::uint64_t task, Session& session, const std::vector<Asked>& asked, Tally& tally);

}  // namespace carom::properties
