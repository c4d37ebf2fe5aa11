// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include <carom/collision/expects.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/answers.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/subject_tally.hpp>
#include <carom/properties/gate/task.hpp>
#include <carom/properties/gate/witness.hpp>

namespace carom::properties {
namespace {

/// Throws std::invalid_argument if a deviation names an unknown invariant or family, or if a declared effect is
/// invalid.
void require_valid_claims(const Subject& subject) {
  for (const std::string& text : subject.deviates) {
    try {
      (void)deviation_from(text);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(std::string("deviates: ") + error.what());
    }
  }
  require_valid(subject.effects, subject.law);
}

class Budget {
 public:
  explicit Budget(const GateOptions& options) : of_(options.budget), start_(Clock::now()) {}

  [[nodiscard]] bool is_spent() const { return of_ && Clock::now() - start_ >= *of_; }

  [[nodiscard]] std::uint64_t milliseconds_spent() const { return milliseconds(Clock::now() - start_); }

  [[nodiscard]] std::uint64_t milliseconds_in_all() const {
    CAROM_EXPECTS(of_.has_value());
    return milliseconds(*of_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  static std::uint64_t milliseconds(std::chrono::nanoseconds time) {
    return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
  }

  std::optional<std::chrono::nanoseconds> of_;
  Clock::time_point start_;
};

/// Reports the progress from one thread at a time.
class Progress {
 public:
  Progress(const GateOptions& options, const Budget& budget) : options_(options), budget_(budget) {
    for (const Family* family : options.families) {
      all_ += options.budget ? 0 : cases_of(options, *family);
    }
  }

  void add(std::uint64_t cases) {
    const std::lock_guard lock(mutex_);
    done_ += cases;
    if (!options_.progress) {
      return;
    }
    if (options_.budget) {
      const std::uint64_t all = budget_.milliseconds_in_all();
      options_.progress(std::min(budget_.milliseconds_spent(), all), all);
    } else {
      options_.progress(done_, all_);
    }
  }

 private:
  const GateOptions& options_;
  const Budget& budget_;
  std::mutex mutex_;
  std::uint64_t done_ = 0;
  std::uint64_t all_ = 0;
};

/// For each subject, the first task that found a violation. All earlier tasks are still judged to the end. So the first
/// violation does not depend on the number of threads.
class Finds {
 public:
  explicit Finds(std::size_t subjects) : first_(subjects) {
    for (std::atomic<std::uint64_t>& task : first_) {
      task = std::numeric_limits<std::uint64_t>::max();
    }
  }

  void add(std::size_t subject, std::uint64_t task) {
    std::uint64_t known = first_[subject];
    while (task < known && !first_[subject].compare_exchange_weak(known, task)) {
    }
  }

  [[nodiscard]] bool was_found_before(std::size_t subject, std::uint64_t task) const { return first_[subject] < task; }

 private:
  std::vector<std::atomic<std::uint64_t>> first_;
};

/// The first fault of the judge in any thread.
class JudgeFault {
 public:
  void set(const oracles::JudgeError& error) {
    const std::lock_guard lock(mutex_);
    first_ = first_ ? first_ : error;
    is_set_ = true;
  }
  [[nodiscard]] bool is_set() const { return is_set_; }
  /// Precondition: all threads have ended.
  [[nodiscard]] const std::optional<oracles::JudgeError>& first() const { return first_; }

 private:
  std::mutex mutex_;
  std::optional<oracles::JudgeError> first_;
  std::atomic<bool> is_set_ = false;
};

/// A few failures show where a subject fails, and each hang costs a timeout.
constexpr unsigned most_failures = 10;

std::deque<Restarts> restarts_of(std::size_t subjects) {
  std::deque<Restarts> restarts;
  for (std::size_t s = 0; s < subjects; ++s) {
    restarts.emplace_back(most_failures);
  }
  return restarts;
}

/// Room for the sampled cases of each family.
std::vector<std::vector<SampledCase>> room_for_samples(const GateOptions& options) {
  std::vector<std::vector<SampledCase>> sampled;
  for (const Family* family : options.families) {
    const std::uint64_t cases = cases_of(options, *family);
    const std::uint64_t end = options.budget || cases == 0 ? cases : options.shard.case_number(cases - 1) + 1;
    sampled.emplace_back(std::min(end, sampled_of(*family)));
  }
  return sampled;
}

/// Removes the places after the last valid case, which belong to cases that were not drawn.
void end_at_last_case(std::vector<SampledCase>& sampled) {
  const auto last = std::find_if(sampled.rbegin(), sampled.rend(), [](const SampledCase& one) { return one.is_valid; });
  sampled.erase(last.base(), sampled.end());
}

/// The state that the threads of a run share.
struct Run {
  const std::vector<Subject>& subjects;
  const std::vector<Claim>& claims;
  const GateOptions& options;
  /// By family and case number. Each case is drawn once, so workers write different elements.
  std::vector<std::vector<SampledCase>> sampled = room_for_samples(options);
  Schedule schedule{options};
  Budget budget{options};
  Progress progress{options, budget};
  Finds finds{subjects.size()};
  JudgeFault judge_fault = {};
  std::deque<Restarts> restarts = restarts_of(subjects.size());  // of each subject
};

class Worker {
 public:
  explicit Worker(Run& run) : run_(&run), coverage_(run.options.families.size()), tallies_(run.subjects.size()) {
    for (const Family* family : run.options.families) {
      for (SubjectTally& tally : tallies_) {
        tally.families.emplace_back().sampled = sampled_of(*family);
      }
    }
  }

  void run() {
    open_sessions();
    const GateOptions& options = run_->options;
    while (!options.stop.stop_requested() && !run_->budget.is_spent() && !run_->judge_fault.is_set()) {
      const std::optional<Task> task = run_->schedule.next();
      if (!task || is_over_for_all(task->number)) {
        break;
      }
      run_unless_judge_failed([&] { judge_all(*task); });
      run_->progress.add(task->last - task->first);
    }
    for (std::size_t s = 0; s < examinees_.size(); ++s) {
      finish(s);
    }
    sessions_.clear();  // in the thread that opened them
  }

  [[nodiscard]] const std::vector<SubjectTally>& tallies() const { return tallies_; }
  [[nodiscard]] const std::vector<Coverage>& coverage() const { return coverage_; }
  [[nodiscard]] const FeatureCoverage& features() const { return features_; }
  [[nodiscard]] const std::optional<FirstViolation>& first_violation(std::size_t subject) const {
    return examinees_[subject].first_violation;
  }

 private:
  [[nodiscard]] std::uint64_t relations_every(const Subject& subject) const {
    constexpr std::uint64_t of_programs = 4;
    constexpr std::uint64_t of_coulomb = 2;  // each answer takes many steps, and equations show nearly all defects
    const std::uint64_t every = subject.is_program() ? of_programs : (subject.law == Law::coulomb ? of_coulomb : 1);
    return run_->options.relations_every > 0 ? run_->options.relations_every : every;
  }

  /// f(), unless a fault of the judge ended the run. Keeps a fault of f.
  template <class F>
  void run_unless_judge_failed(const F& f) {
    if (run_->judge_fault.is_set()) {
      return;
    }
    try {
      f();
    } catch (const oracles::JudgeError& error) {
      run_->judge_fault.set(error);
    }
  }

  /// A subject that throws is not judged further, and its results so far stay. A fault of the judge is kept apart.
  template <class F>
  void run_unless_failed(std::size_t subject, const F& f) {
    if (!tallies_[subject].error.empty()) {
      return;
    }
    const auto note = [&](const std::exception& exception) {
      if (!run_->options.stop.stop_requested()) {
        tallies_[subject].error = exception.what();
      }
    };
    run_unless_judge_failed([&] {
      try {
        f();
      } catch (const SubjectError& error) {
        note(error);
      } catch (const SessionFailure& failure) {
        note(failure);
      }
    });
  }

  void judge_all(const Task& task) {
    const std::deque<JudgedCase> cases = cases_in(task);
    for (std::size_t s = 0; s < examinees_.size(); ++s) {
      if (!run_->finds.was_found_before(s, task.number)) {
        run_unless_failed(s, [&] {
          judge_task(examinees_[s], task, cases, tallies_[s]);
          note_find(s);
        });
      }
    }
  }

  void open_sessions() {
    const std::vector<Subject>& subjects = run_->subjects;
    sessions_.resize(subjects.size());
    for (std::size_t s = 0; s < subjects.size(); ++s) {
      examinees_.push_back({subjects[s], run_->claims[s], run_->options.families, sessions_[s],
                            relations_every(subjects[s]), run_->options.fail_fast});
      run_unless_failed(s, [&] {
        of_subject([&] { require_valid_claims(subjects[s]); });
        sessions_[s] = open_restarting(subjects[s], run_->restarts[s], run_->options.stop);
      });
    }
  }

  /// Whether no subject needs further cases. The result is false in a run that has neither a budget nor `fail_fast`,
  /// because there further cases count in the coverage.
  [[nodiscard]] bool is_over_for_all(std::uint64_t task) const {
    bool is_over = run_->options.budget || run_->options.fail_fast;
    for (std::size_t s = 0; s < examinees_.size(); ++s) {
      is_over = is_over && (run_->finds.was_found_before(s, task) || !tallies_[s].error.empty());
    }
    return is_over;
  }

  std::deque<JudgedCase> cases_in(const Task& task) {
    const Family& family = *run_->options.families[task.family];
    std::deque<JudgedCase> cases;
    for (std::uint64_t i = 0; i < task.last - task.first; ++i) {
      const Case drawn = drawn_case_within(run_->options.within, family, run_->options.seed, task.case_number(i));
      oracles::on_collision(drawn.collision, [&] {
        const JudgedCase& one = cases.emplace_back(drawn, run_->options.limits.filtered);
        coverage_[task.family] += coverage_of(one);
        if (one.is_valid()) {
          look_at(task.family, task.case_number(i), one);
        }
      });
    }
    return cases;
  }

  void look_at(std::size_t family, std::uint64_t index, const JudgedCase& one) {
    const oracles::ContactState approach = one.exact().state();
    const bool is_sampled = index < sampled_of(*run_->options.families[family]);
    if (!is_sampled && approach != oracles::ContactState::colliding) {
      return;
    }
    std::vector<std::uint16_t> present = feature_places_of(one.generated().collision);
    if (approach == oracles::ContactState::colliding) {
      features_.add(present);
    }
    if (is_sampled) {
      run_->sampled[family][index] = sampled_case(one, std::move(present));
    }
  }

  void note_find(std::size_t subject) {
    if (const auto& found = examinees_[subject].first_violation) {
      run_->finds.add(subject, found->task);
    }
  }

  /// Closes the subject's session, then asks the remembered cases again in a new session. If a first violation ended
  /// the subject's run, or a fault of the judge ended the run, only closes the session. Otherwise, does nothing if the
  /// subject has an error.
  void finish(std::size_t subject) {
    constexpr std::uint64_t after_all_tasks = std::numeric_limits<std::uint64_t>::max() - 1;
    Examinee& examinee = examinees_[subject];
    if (run_->finds.was_found_before(subject, after_all_tasks) || run_->judge_fault.is_set()) {
      try {
        examinee.session.close();
      } catch (const std::exception&) {
        // The subject is not asked again.
      }
      return;
    }
    run_unless_failed(subject, [&] {
      examinee.session.close();
      Session fresh = open_restarting(examinee.subject, run_->restarts[subject], run_->options.stop);
      ask_again(examinee, after_all_tasks, fresh, examinee.remembered, tallies_[subject]);
      note_find(subject);
      fresh.close();
    });
  }

  Run* run_;
  std::vector<Session> sessions_;
  std::vector<Examinee> examinees_;
  std::vector<Coverage> coverage_;
  std::vector<SubjectTally> tallies_;
  FeatureCoverage features_;
};

std::vector<Worker> workers_of(Run& run) {
  return std::vector<Worker>(std::max(1U, run.options.workers.count), Worker(run));
}

SubjectTally tally_of(const std::vector<Worker>& workers, std::size_t subject, const Claim& claim) {
  SubjectTally tally = workers[0].tallies()[subject];
  for (std::size_t w = 1; w < workers.size(); ++w) {
    tally += workers[w].tallies()[subject];
  }
  const FirstViolation* first = nullptr;
  for (const Worker& worker : workers) {
    const auto& found = worker.first_violation(subject);
    first = found && (first == nullptr || found->task < first->task) ? &*found : first;
  }
  if (first != nullptr) {
    first->add_to(tally, claim);
  }
  for (FamilyResult& family : tally.families) {
    family.order_cases();
  }
  return tally;
}

/// Gives the families beyond the claimed domain to the subjects that were judged to the end.
void judge_beyond_domain(const std::vector<Subject>& subjects, const std::vector<Claim>& claims,
                         const GateOptions& options, GateReport& report) {
  std::vector<SubjectResult>& results = report.results;
  if (options.beyond_domain.empty() || options.budget || options.fail_fast || report.judge_error) {
    return;
  }
  std::vector<std::size_t> judged_to_the_end;
  std::vector<Subject> posed;
  std::vector<Claim> claimed;
  for (std::size_t s = 0; s < results.size(); ++s) {
    if (results[s].error.empty()) {
      judged_to_the_end.push_back(s);
      posed.push_back(subjects[s]);
      claimed.push_back(claims[s]);
    }
  }
  GateOptions beyond = options;
  beyond.families = options.beyond_domain;
  beyond.progress = {};
  Run run{posed, claimed, beyond};
  std::vector<Worker> workers = workers_of(run);
  options.workers.run(workers.size(), [&](std::size_t worker) { workers[worker].run(); });
  for (std::size_t i = 0; i < judged_to_the_end.size(); ++i) {
    SubjectTally tally = tally_of(workers, i, claimed[i]);
    results[judged_to_the_end[i]].beyond_domain = std::move(tally.families);
    results[judged_to_the_end[i]].error_beyond_domain = std::move(tally.error);
  }
  report.judge_error = run.judge_fault.first();
}

}  // namespace

GateReport run_gate(const std::vector<Subject>& subjects, const GateOptions& options) {
  CAROM_EXPECTS(!options.budget || options.shard.of == 1, options.shard.of);
  std::vector<Claim> claims;
  claims.reserve(subjects.size());
  for (const Subject& subject : subjects) {
    CAROM_EXPECTS(subject.absent.empty(), subject.name, subject.absent);
    claims.push_back(claim_of(subject, options.limits));
    claims.back().within = options.within;
  }
  Run run{subjects, claims, options};
  std::vector<Worker> workers = workers_of(run);
  options.workers.run(workers.size(), [&](std::size_t worker) { workers[worker].run(); });

  GateReport report{options,
                    std::vector<Coverage>(options.families.size()),
                    {},
                    std::move(run.sampled),
                    {},
                    false,
                    run.judge_fault.first()};
  for (std::vector<SampledCase>& of_family : report.sampled) {
    end_at_last_case(of_family);
  }
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    const SubjectTally tally = tally_of(workers, s, claims[s]);
    SubjectResult result{subjects[s], tally.error, tally.families, tally.digits, 0, {}, {}, {}, {}, {}, {}};
    if (const Histogram<TimeScale>& times = tally.nanoseconds_per_solve; times.size() > 0) {
      // Other programs disturb single batches by far more than solvers differ, so the report gives the median.
      result.nanoseconds_per_solve = times.at(times.size() / 2);
    }
    report.results.push_back(std::move(result));
  }
  for (const Worker& worker : workers) {
    report.features += worker.features();
    for (std::size_t f = 0; f < report.coverage.size(); ++f) {
      report.coverage[f] += worker.coverage()[f];
    }
  }
  judge_beyond_domain(subjects, claims, options, report);
  state_what_was_not_judged(report);
  add_witnesses(report);
  report.interrupted = options.stop.stop_requested();
  return report;
}

}  // namespace carom::properties
