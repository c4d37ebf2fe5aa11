// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/tally.hpp>
#include <carom/properties/search/witness.hpp>
#include <carom/properties/trial/answers.hpp>

namespace carom::properties {
namespace {

/// Cases that are put to a subject at once.
constexpr std::uint64_t cases_in_task = 50;

/// Cases of a thread that are asked again in a session of their own.
constexpr std::size_t most_remembered = 64;

/// What a session made of a batch: fewer answers than collisions where it failed.
struct Batch {
  std::vector<Answer> answers;
  std::exception_ptr failure;
};

Batch batch_of(Session& session, std::span<const Collision> collisions) {
  try {
    return {answers_of(session, collisions), nullptr};
  } catch (const SessionFailure& failure) {
    return {failure.answered(), std::current_exception()};
  }
}

/// Throws std::invalid_argument where the subject deviates from what is no invariant: it would claim all the same.
void require_known_deviations(const Subject& subject) {
  for (const std::string& name : subject.deviates) {
    if (invariant_named(name) == nullptr) {
      throw std::invalid_argument("deviates: there is no invariant \"" + name + '"');
    }
  }
}

/// A case, and what was answered to it.
struct Asked {
  std::size_t family;
  std::uint64_t index;
  Case one;
  Answer answer;
};

/// What a session may not make anything of, to be asked in between.
Collision invalid_collision() {
  Collision invalid;
  invalid.a.mass = std::numeric_limits<double>::quiet_NaN();
  return invalid;
}

/// Asks cases again, the last ones first, after an invalid one, and judges whether the answers are the same.
void ask_again(const Claim& claim, Session& session, const std::vector<Asked>& asked, Tally& tally) {
  std::vector<Collision> questions{invalid_collision()};
  for (auto one = asked.rbegin(); one != asked.rend(); ++one) {
    questions.push_back(one->one.collision);
  }
  const std::vector<Answer> again = answers_of(session, questions);
  for (const Invariant* invariant : claim.invariants) {
    if (const auto* about = std::get_if<AboutSession>(&invariant->about)) {
      for (std::size_t i = 0; i < asked.size(); ++i) {
        const Asked& first = asked[asked.size() - 1 - i];
        tally.add(first.family, first.index, first.one, first.answer,
                  {invariant, about->check(first.answer, again[i + 1])});
      }
    }
  }
}

/// Some cases of a task, to be asked again.
std::vector<Asked> sample_of(std::size_t family, std::uint64_t first, const std::deque<JudgedCase>& cases,
                             const std::vector<Answer>& answers) {
  constexpr std::size_t every = 10;
  std::vector<Asked> sample;
  for (std::size_t i = 0; i < cases.size(); i += every) {
    sample.push_back({family, first + i, cases[i].generated(), answers[i]});
  }
  return sample;
}

/// Puts the cases of one task to one subject: first all cases, then all questions that their answers raise. Where the
/// session fails, what it had answered is judged, the invariants that ask further questions left out.
void judge_task(const Subject& subject, const Claim& claim, Session& session, std::size_t family, std::uint64_t first,
                std::uint64_t relations_every, const std::deque<JudgedCase>& cases, Tally& tally,
                std::vector<Asked>& remembered) {
  std::vector<Collision> collisions;
  collisions.reserve(cases.size());
  for (const JudgedCase& one : cases) {
    collisions.push_back(one.generated().collision);
  }
  const auto start = std::chrono::steady_clock::now();
  const Batch batch = batch_of(session, collisions);
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;

  const auto trials_of = [&](bool with_relations) {
    std::vector<Trial> trials;
    for (std::size_t i = 0; i < batch.answers.size(); ++i) {
      trials.emplace_back(cases[i], claim, lift(batch.answers[i]), shown_collision_matrix(subject, cases[i]),
                          with_relations && (first + i) % relations_every == 0);
    }
    return trials;
  };
  std::vector<Trial> trials = trials_of(!batch.failure);
  std::vector<Collision> questions;
  for (const Trial& trial : trials) {
    const std::vector<Collision> of_trial = trial.questions();
    questions.insert(questions.end(), of_trial.begin(), of_trial.end());
  }
  const Batch related = questions.empty() ? Batch{} : batch_of(session, questions);
  if (related.failure) {
    trials = trials_of(false);
  }
  std::span<const Answer> rest;
  if (!related.failure) {
    rest = related.answers;
  }
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const std::size_t count = trials[i].question_count();
    tally.add(family, first + i, cases[i], batch.answers[i],
              trials[i].judge(rest.first(count), tally.families[family].worst_backward_error), claim);
    rest = rest.subspan(count);
  }
  for (const std::exception_ptr& failure : {batch.failure, related.failure}) {
    if (failure) {
      std::rethrow_exception(failure);
    }
  }
  const std::vector<Asked> sample = sample_of(family, first, cases, batch.answers);
  ask_again(claim, session, sample, tally);
  if (remembered.size() < most_remembered) {
    remembered.push_back(sample.front());
  }
  tally.nanoseconds_per_solve.add(elapsed.count() / static_cast<double>(collisions.size()));
}

/// Cases of one family: from `first` to before `last`.
struct Task {
  std::size_t family;
  std::uint64_t first;
  std::uint64_t last;
};

std::vector<Task> all_tasks(const GateOptions& options) {
  std::vector<Task> tasks;
  for (std::size_t family = 0; family < options.families.size(); ++family) {
    const std::uint64_t cases = cases_of(options, *options.families[family]);
    for (std::uint64_t first = 0; first < cases; first += cases_in_task) {
      tasks.push_back({family, first, std::min(first + cases_in_task, cases)});
    }
  }
  return tasks;
}

/// The work of one thread: takes tasks until there are none left.
class Worker {
 public:
  Worker(const std::vector<Subject>& subjects, const std::vector<Claim>& claims, const GateOptions& options)
      : subjects_(subjects), claims_(claims), options_(options), coverage_(options.families.size()) {
    tallies_.resize(subjects.size());
    remembered_.resize(subjects.size());
    for (Tally& tally : tallies_) {
      tally.families.resize(options.families.size());
    }
  }

  template <class NextTask, class Done>
  void run(NextTask next_task, Done done) {
    open_sessions();
    const std::vector<Task> tasks = all_tasks(options_);
    for (std::uint64_t task = next_task(); task < tasks.size() && !options_.stop.stop_requested(); task = next_task()) {
      // No structured binding: clang before 16 captures none.
      const std::size_t family = tasks[task].family;
      const std::uint64_t first = tasks[task].first;
      const std::uint64_t last = tasks[task].last;
      std::deque<JudgedCase> cases;
      for (std::uint64_t index = first; index < last; ++index) {
        Stream stream = case_stream(options_.seed, options_.families[family]->name, index);
        cases.emplace_back(options_.families[family]->generate(stream), options_.yardstick.filtered);
        coverage_[family] += coverage_of(cases.back());
        if (cases.back().is_valid() && cases.back().exact().approach() == oracles::Approach::colliding) {
          features_.add(cases.back().generated().collision);
        }
      }
      for (std::size_t s = 0; s < subjects_.size(); ++s) {
        guarded(s, [&] {
          judge_task(subjects_[s], claims_[s], sessions_[s], family, first, relations_every(subjects_[s]), cases,
                     tallies_[s], remembered_[s]);
        });
      }
      done(last - first);
    }
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      guarded(s, [&] {
        sessions_[s].close();
        Session fresh = subjects_[s].open();
        ask_again(claims_[s], fresh, remembered_[s], tallies_[s]);
        fresh.close();
      });
    }
    for (Tally& tally : tallies_) {
      tally.name_counts();
    }
    sessions_.clear();  // in the thread that opened them
  }

  [[nodiscard]] const std::vector<Tally>& tallies() const { return tallies_; }
  [[nodiscard]] const std::vector<Coverage>& coverage() const { return coverage_; }
  [[nodiscard]] const FeatureCoverage& features() const { return features_; }

 private:
  [[nodiscard]] std::uint64_t relations_every(const Subject& subject) const {
    constexpr std::uint64_t of_programs = 8;
    const bool is_program = !subject.specification.empty();
    return options_.relations_every > 0 ? options_.relations_every : (is_program ? of_programs : 1);
  }

  /// A subject that throws is judged no further; what was found of it stays.
  template <class F>
  void guarded(std::size_t subject, const F& f) {
    if (!tallies_[subject].error.empty()) {
      return;
    }
    try {
      f();
    } catch (const std::exception& exception) {
      if (!options_.stop.stop_requested()) {
        tallies_[subject].error = exception.what();
      }
    }
  }

  void open_sessions() {
    sessions_.resize(subjects_.size());
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      guarded(s, [&] {
        require_known_deviations(subjects_[s]);
        sessions_[s] = subjects_[s].open();
      });
    }
  }

  const std::vector<Subject>& subjects_;
  const std::vector<Claim>& claims_;
  const GateOptions& options_;
  std::vector<Session> sessions_;
  std::vector<Tally> tallies_;
  std::vector<std::vector<Asked>> remembered_;  // of each subject
  std::vector<Coverage> coverage_;
  FeatureCoverage features_;
};

/// Runs work(0), …, work(count − 1) on so many threads.
template <class Work>
void in_parallel(unsigned jobs, std::size_t count, const Work& work) {
  std::atomic<std::size_t> next = 0;
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      work(i);
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 1; i < jobs; ++i) {
    threads.emplace_back(run);
  }
  run();
}

}  // namespace

GateReport run_gate(const std::vector<Subject>& subjects, const GateOptions& options) {
  std::vector<Claim> claims;
  claims.reserve(subjects.size());
  for (const Subject& subject : subjects) {
    claims.push_back(claim_of(subject, options.yardstick));
  }
  const unsigned jobs = std::max(1U, options.jobs);
  std::vector<Worker> workers(jobs, Worker(subjects, claims, options));
  std::atomic<std::uint64_t> next_task = 0;
  std::mutex progress_mutex;
  std::uint64_t done = 0;
  std::uint64_t all = 0;
  for (const Family* family : options.families) {
    all += cases_of(options, *family);
  }
  in_parallel(jobs, jobs, [&](std::size_t worker) {
    workers[worker].run([&] { return next_task++; },
                        [&](std::uint64_t count) {
                          const std::lock_guard lock(progress_mutex);
                          done += count;
                          if (options.progress) {
                            options.progress(done, all);
                          }
                        });
  });

  GateReport report{options, std::vector<Coverage>(options.families.size()), {}, {}, false};
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    Tally tally = workers[0].tallies()[s];
    for (std::size_t w = 1; w < workers.size(); ++w) {
      tally += workers[w].tallies()[s];
    }
    SubjectResult result{subjects[s], tally.error, tally.families, tally.digits, 0, {}, {}};
    if (const Histogram<TimeScale>& times = tally.nanoseconds_per_solve; times.size() > 0) {
      // The median: other programs disturb single batches by far more than solvers differ.
      result.nanoseconds_per_solve = times.at(times.size() / 2);
    }
    for (const std::string& invariant : result.violated_invariants()) {
      result.witnesses.push_back(found_witness(result, options, invariant));
    }
    report.results.push_back(std::move(result));
  }
  for (const Worker& worker : workers) {
    report.features += worker.features();
    for (std::size_t f = 0; f < report.coverage.size(); ++f) {
      report.coverage[f] += worker.coverage()[f];
    }
  }
  for (SubjectResult& result : report.results) {
    result.not_judged = why_not_judged(result, options.families, report.coverage);
  }
  struct FoundWitness {
    std::size_t subject;
    std::size_t witness;
  };
  std::vector<FoundWitness> places;
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    for (std::size_t w = 0; w < report.results[s].witnesses.size(); ++w) {
      places.push_back({s, w});
    }
  }
  in_parallel(jobs, places.size(), [&](std::size_t i) {
    SubjectResult& result = report.results[places[i].subject];
    Witness& witness = result.witnesses[places[i].witness];
    try {
      if (!options.stop.stop_requested()) {
        witness = shrunk_witness(result.subject, claims[places[i].subject], witness);
      }
    } catch (const std::exception&) {
      // The violation stands as it was found.
    }
  });
  report.interrupted = options.stop.stop_requested();
  return report;
}

}  // namespace carom::properties
