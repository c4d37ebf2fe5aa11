// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>
#include <carom/properties/gate/subject_tally.hpp>

namespace carom::properties {

/// The cases of one family from `first` to `last` − 1, which a subject gets at once.
struct Task {
  std::uint64_t number = 0;  // in the schedule, from 0
  std::size_t family = 0;    // place in the options
  std::uint64_t first = 0;   // in the order of the family's cases in the shard
  std::uint64_t last = 0;
  Shard shard = {};

  /// The number, in its family, of the task's `i`-th case. Both count from 0.
  [[nodiscard]] std::uint64_t case_number(std::uint64_t i) const { return shard.case_number(first + i); }
};

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

/// The order of the cases in a run, the same for any number of threads. The families take turns by `Family::turn`. A
/// turn has one case (times the family's weight) in the first round, and twice as many in each further round. So the
/// first cases show a widespread defect. Threads may share a schedule.
class Schedule {
 public:
  explicit Schedule(const GateOptions& options);

  /// The next task; none if all cases were handed out. With a budget, there is always one.
  [[nodiscard]] std::optional<Task> next();

 private:
  struct Place {
    std::size_t family;
    std::uint64_t weight;
    std::uint64_t cases;         // in all
    std::uint64_t drawn = 0;     // cases handed out so far
    std::uint64_t turn_end = 0;  // `drawn` at the end of its turn
  };

  void start_turn();

  std::mutex mutex_;
  Shard shard_;
  std::vector<Place> places_;  // in the order of the turns
  std::size_t turn_ = 0;       // place of the family whose turn it is
  std::uint64_t cases_in_turn_ = 1;
  std::uint64_t next_number_ = 0;
};

}  // namespace carom::properties
