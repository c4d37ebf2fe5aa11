// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <deque>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <carom/properties/gate.hpp>
#include <carom/properties/shrink.hpp>

namespace carom::properties {
namespace {

using oracles::Approach;

/// Cases that are put to a subject at once.
constexpr std::uint64_t cases_in_task = 50;

/// Shrinking calls the subject and the judge this often at most for one witness.
constexpr std::size_t most_shrink_calls = 4000;

bool is_isotropic(const Body& body) {
  return body.immovable || (body.principal_inertia[0] == body.principal_inertia[1] &&
                            body.principal_inertia[1] == body.principal_inertia[2]);
}

Coverage coverage_of(const JudgedCase& judged_case) {
  Coverage coverage;
  coverage.cases = 1;
  if (!judged_case.is_valid()) {
    coverage.invalid = 1;
    return coverage;
  }
  const Collision& c = judged_case.generated().collision;
  const Approach approach = judged_case.exact().approach();
  coverage.colliding = approach == Approach::colliding ? 1 : 0;
  coverage.resting = approach == Approach::resting ? 1 : 0;
  coverage.separating = approach == Approach::separating ? 1 : 0;
  coverage.inert = approach == Approach::inert ? 1 : 0;
  coverage.one_immovable = c.a.immovable != c.b.immovable ? 1 : 0;
  coverage.spheres =
      approach != Approach::inert && is_isotropic(c.a) && is_isotropic(c.b) && judged_case.exact().is_collinear() ? 1
                                                                                                                  : 0;
  coverage.head_on = approach == Approach::colliding && judged_case.exact().is_head_on() ? 1 : 0;
  coverage.inelastic = c.restitution == 0 ? 1 : 0;
  coverage.elastic = c.restitution == 1 ? 1 : 0;
  return coverage;
}

/// What one thread found of one subject.
struct Tally {
  std::string error;
  std::vector<FamilyResult> families;
  std::vector<float> digits;
  std::vector<double> nanoseconds_per_solve;  // of each task

  void add(std::size_t family, std::uint64_t index, const JudgedCase& judged_case, const Answer& answer,
           const Judgement& judgement, const Claim& claim) {
    FamilyResult& result = families[family];
    ++result.cases;
    result.skipped += judgement.skipped ? 1 : 0;
    if (judgement.accuracy && judgement.accuracy->is_decided) {
      result.worst_backward_error =
          std::max(result.worst_backward_error, judgement.accuracy->backward_error(claim.yardstick.unit_roundoff));
      if (judged_case.exact().approach() == Approach::colliding) {
        digits.push_back(static_cast<float>(judgement.accuracy->digits()));
      }
    }
    bool any_violated = false;
    for (const NamedVerdict& named : judgement.verdicts) {
      any_violated = any_violated || named.verdict.status == Status::violated;
      const std::string name(named.invariant->name);
      Count& count = result.counts[name];
      switch (named.verdict.status) {
        case Status::holds:
          ++count.holds;
          break;
        case Status::skipped:
          ++count.skipped;
          break;
        case Status::violated:
          ++count.violated;
          keep_worst(result, name, {index, judged_case.generated(), named.verdict, answer});
      }
    }
    result.violated += any_violated ? 1 : 0;
  }

  static void keep_worst(FamilyResult& result, const std::string& invariant, const WorstViolation& violation) {
    const auto [known, is_new] = result.worst.emplace(invariant, violation);
    const double severity = violation.verdict.severity();
    const double known_severity = known->second.verdict.severity();
    const bool is_worse =
        severity > known_severity || (severity == known_severity && violation.index < known->second.index);
    if (!is_new && is_worse) {
      known->second = violation;
    }
  }

  Tally& operator+=(const Tally& other) {
    if (error.empty()) {
      error = other.error;
    }
    for (std::size_t f = 0; f < families.size(); ++f) {
      FamilyResult& into = families[f];
      const FamilyResult& from = other.families[f];
      into.cases += from.cases;
      into.skipped += from.skipped;
      into.violated += from.violated;
      into.worst_backward_error = std::max(into.worst_backward_error, from.worst_backward_error);
      for (const auto& [name, count] : from.counts) {
        into.counts[name].holds += count.holds;
        into.counts[name].violated += count.violated;
        into.counts[name].skipped += count.skipped;
      }
      for (const auto& [name, violation] : from.worst) {
        keep_worst(into, name, violation);
      }
    }
    digits.insert(digits.end(), other.digits.begin(), other.digits.end());
    nanoseconds_per_solve.insert(nanoseconds_per_solve.end(), other.nanoseconds_per_solve.begin(),
                                 other.nanoseconds_per_solve.end());
    return *this;
  }
};

/// The answers of a session, one to each collision. Throws std::runtime_error where it gives more or fewer.
std::vector<Answer> answers_of(Session& session, std::span<const Collision> collisions) {
  std::vector<Answer> answers = session(collisions);
  if (answers.size() != collisions.size()) {
    throw std::runtime_error("the session gave " + std::to_string(answers.size()) + " answers to " +
                             std::to_string(collisions.size()) + " collisions");
  }
  return answers;
}

std::vector<ExactAnswer> lifted(const std::vector<Answer>& answers) {
  std::vector<ExactAnswer> result;
  result.reserve(answers.size());
  for (const Answer& answer : answers) {
    result.push_back(lift(answer));
  }
  return result;
}

/// Puts the cases of one task to one subject: first all cases, then all questions that their answers raise.
void judge_task(const Subject& subject, const Claim& claim, Session& session, std::size_t family, std::uint64_t first,
                std::uint64_t relations_every, const std::deque<JudgedCase>& cases, Tally& tally) {
  std::vector<Collision> collisions;
  collisions.reserve(cases.size());
  for (const JudgedCase& one : cases) {
    collisions.push_back(one.generated().collision);
  }
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Answer> answers = answers_of(session, collisions);
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
  tally.nanoseconds_per_solve.push_back(elapsed.count() / static_cast<double>(collisions.size()));

  std::vector<Trial> trials;
  trials.reserve(cases.size());
  std::vector<Collision> questions;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    trials.emplace_back(cases[i], claim, lift(answers[i]), shown_collision_matrix(subject, cases[i]),
                        (first + i) % relations_every == 0);
    questions.insert(questions.end(), trials.back().questions().begin(), trials.back().questions().end());
  }
  const std::vector<ExactAnswer> replies = lifted(answers_of(session, questions));
  std::span<const ExactAnswer> rest(replies);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::size_t count = trials[i].questions().size();
    tally.add(family, first + i, cases[i], answers[i], trials[i].judge(rest.first(count)), claim);
    rest = rest.subspan(count);
  }
}

/// The work of one thread: takes tasks until there are none left.
class Worker {
 public:
  Worker(const std::vector<Subject>& subjects, const std::vector<Claim>& claims, const GateOptions& options)
      : subjects_(subjects), claims_(claims), options_(options), coverage_(options.families.size()) {
    tallies_.resize(subjects.size());
    for (Tally& tally : tallies_) {
      tally.families.resize(options.families.size());
    }
  }

  template <class NextTask, class Done>
  void run(NextTask next_task, Done done) {
    open_sessions();
    const std::uint64_t tasks_in_family = (options_.cases + cases_in_task - 1) / cases_in_task;
    for (std::uint64_t task = next_task();
         task < tasks_in_family * options_.families.size() && !options_.stop.stop_requested(); task = next_task()) {
      const auto family = static_cast<std::size_t>(task / tasks_in_family);
      const std::uint64_t first = task % tasks_in_family * cases_in_task;
      const std::uint64_t last = std::min(first + cases_in_task, options_.cases);
      std::deque<JudgedCase> cases;
      for (std::uint64_t index = first; index < last; ++index) {
        Stream stream = case_stream(options_.seed, options_.families[family]->name, index);
        cases.emplace_back(options_.families[family]->generate(stream));
        coverage_[family] += coverage_of(cases.back());
      }
      for (std::size_t s = 0; s < subjects_.size(); ++s) {
        guarded(s, [&] {
          judge_task(subjects_[s], claims_[s], sessions_[s], family, first, relations_every(subjects_[s]), cases,
                     tallies_[s]);
        });
      }
      done(last - first);
    }
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      guarded(s, [&] { sessions_[s].close(); });
    }
    sessions_.clear();  // in the thread that opened them
  }

  [[nodiscard]] const std::vector<Tally>& tallies() const { return tallies_; }
  [[nodiscard]] const std::vector<Coverage>& coverage() const { return coverage_; }

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
      guarded(s, [&] { sessions_[s] = subjects_[s].open(); });
    }
  }

  const std::vector<Subject>& subjects_;
  const std::vector<Claim>& claims_;
  const GateOptions& options_;
  std::vector<Session> sessions_;
  std::vector<Tally> tallies_;
  std::vector<Coverage> coverage_;
};

AnswerAndJudgement judge_in_session(const Subject& subject, const Claim& claim, Session& session, const Case& one) {
  const JudgedCase judged_case(one);
  const Answer answer = answers_of(session, std::span(&one.collision, 1)).front();
  const Trial trial(judged_case, claim, lift(answer), shown_collision_matrix(subject, judged_case));
  const std::vector<ExactAnswer> replies =
      trial.questions().empty() ? std::vector<ExactAnswer>{} : lifted(answers_of(session, trial.questions()));
  return {answer, trial.judge(replies)};
}

/// The verdict of a claim that holds a single invariant; `holds` where it has none on this case.
Verdict single_verdict(const Judgement& judgement) {
  return judgement.verdicts.empty() ? Verdict{} : judgement.verdicts.front().verdict;
}

/// The family in which the invariant is violated most often shows it best.
std::size_t family_of_witness(const SubjectResult& result, const std::string& invariant) {
  std::size_t best = 0;
  std::uint64_t most = 0;
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    const auto found = result.families[f].counts.find(invariant);
    const std::uint64_t violated = found == result.families[f].counts.end() ? 0 : found->second.violated;
    if (violated > most) {
      most = violated;
      best = f;
    }
  }
  return best;
}

/// A witness as it was found.
Witness found_witness(const SubjectResult& result, const GateOptions& options, const std::string& invariant) {
  const std::size_t family = family_of_witness(result, invariant);
  const WorstViolation& worst = result.families[family].worst.at(invariant);
  return {invariant,      std::string(options.families[family]->name),
          worst.index,    worst.original,
          worst.original, worst.verdict,
          worst.answer};
}

/// The witness with the simplest collision that can be found.
Witness shrunk_witness(const Subject& subject, const Claim& claim, Witness witness) {
  Claim only = claim;
  only.invariants = {invariant_named(witness.invariant)};
  Session session = subject.open();
  // A violation that shrinks to one just beyond the limit convinces nobody.
  const double severity_kept = std::max(1.0, witness.verdict.severity() / 16);
  const auto fails = [&](const Collision& collision) {
    const AnswerAndJudgement shrunk =
        judge_in_session(subject, only, session, {collision, witness.original.convex_uniform});
    return single_verdict(shrunk.judgement).severity() >= severity_kept;
  };
  Case simplest = witness.original;
  // An invalid collision is as small as its family makes it, and what "convex" rests on would not survive.
  if (JudgedCase(witness.original).is_valid() && witness.invariant != "well_conditioned") {
    simplest.collision = shrink(witness.original.collision, fails, most_shrink_calls);
  }
  only.yardstick.filtered = false;  // what is shown was worked out in exact arithmetic, and the truth certified
  const AnswerAndJudgement shrunk = judge_in_session(subject, only, session, simplest);
  session.close();
  if (single_verdict(shrunk.judgement).status == Status::violated) {
    witness.shrunk = simplest;
    witness.verdict = single_verdict(shrunk.judgement);
    witness.answer = shrunk.answer;
  }
  return witness;
}

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

Coverage& Coverage::operator+=(const Coverage& other) {
  cases += other.cases;
  colliding += other.colliding;
  resting += other.resting;
  separating += other.separating;
  inert += other.inert;
  invalid += other.invalid;
  one_immovable += other.one_immovable;
  spheres += other.spheres;
  head_on += other.head_on;
  inelastic += other.inelastic;
  elastic += other.elastic;
  return *this;
}

std::uint64_t SubjectResult::cases() const {
  std::uint64_t sum = 0;
  for (const FamilyResult& family : families) {
    sum += family.cases;
  }
  return sum;
}

std::uint64_t SubjectResult::skipped() const {
  std::uint64_t sum = 0;
  for (const FamilyResult& family : families) {
    sum += family.skipped;
  }
  return sum;
}

Count SubjectResult::count(const std::string& invariant) const {
  Count sum;
  for (const FamilyResult& family : families) {
    const auto found = family.counts.find(invariant);
    if (found != family.counts.end()) {
      sum.holds += found->second.holds;
      sum.violated += found->second.violated;
      sum.skipped += found->second.skipped;
    }
  }
  return sum;
}

std::vector<std::string> SubjectResult::violated_invariants() const {
  std::vector<std::string> names;
  for (const Invariant& invariant : all_invariants()) {
    if (count(std::string(invariant.name)).violated > 0) {
      names.emplace_back(invariant.name);
    }
  }
  return names;
}

bool SubjectResult::is_sound() const { return error.empty() && cases() > skipped() && violated_invariants().empty(); }

std::optional<double> SubjectResult::digits_at_least(double share) const {
  if (digits.empty()) {
    return std::nullopt;
  }
  const auto count = static_cast<double>(digits.size());
  const auto above = static_cast<std::size_t>(std::ceil(share * count));
  return digits[digits.size() - std::clamp<std::size_t>(above, 1, digits.size())];
}

SubjectResult::WorstFamily SubjectResult::worst_backward_error(const GateOptions& options) const {
  WorstFamily worst;
  for (std::size_t f = 0; f < families.size(); ++f) {
    if (families[f].worst_backward_error > worst.backward_error) {
      worst = {families[f].worst_backward_error, std::string(options.families[f]->name)};
    }
  }
  return worst;
}

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
  const std::uint64_t all = options.cases * options.families.size();
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

  GateReport report{options, std::vector<Coverage>(options.families.size()), {}, false};
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    Tally tally = workers[0].tallies()[s];
    for (std::size_t w = 1; w < workers.size(); ++w) {
      tally += workers[w].tallies()[s];
    }
    std::sort(tally.digits.begin(), tally.digits.end());
    SubjectResult result{subjects[s], tally.error, tally.families, tally.digits, 0, {}};
    if (std::vector<double>& times = tally.nanoseconds_per_solve; !times.empty()) {
      // The median: other programs disturb single batches by far more than solvers differ.
      const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
      std::nth_element(times.begin(), middle, times.end());
      result.nanoseconds_per_solve = *middle;
    }
    for (const std::string& invariant : result.violated_invariants()) {
      result.witnesses.push_back(found_witness(result, options, invariant));
    }
    report.results.push_back(std::move(result));
  }
  for (const Worker& worker : workers) {
    for (std::size_t f = 0; f < report.coverage.size(); ++f) {
      report.coverage[f] += worker.coverage()[f];
    }
  }
  struct Place {
    std::size_t subject;
    std::size_t witness;
  };
  std::vector<Place> places;
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

AnswerAndJudgement judge_one(const Subject& subject, const Claim& claim, const Case& one) {
  Session session = subject.open();
  AnswerAndJudgement judged = judge_in_session(subject, claim, session, one);
  session.close();
  return judged;
}

}  // namespace carom::properties
