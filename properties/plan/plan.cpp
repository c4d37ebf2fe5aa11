// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <stdexcept>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/gate/answers.hpp>
#include <carom/properties/plan/contact_class.hpp>
#include <carom/properties/plan/lint.hpp>
#include <carom/properties/plan/plan.hpp>

namespace carom::properties::plan {
namespace {

constexpr std::size_t block_size = 64;

struct ClassTally {
  std::size_t colliding = 0;
  std::vector<LawCount> laws;
  std::vector<Certificate> certificates;  // one for each candidate

  ClassTally& operator+=(const ClassTally& other) {
    colliding += other.colliding;
    for (std::size_t i = 0; i < laws.size(); ++i) {
      laws[i].by_reason += other.laws[i].by_reason;
    }
    for (std::size_t i = 0; i < certificates.size(); ++i) {
      certificates[i] += other.certificates[i];
    }
    return *this;
  }
};

class Judging {
 public:
  Judging(std::span<const Collision> collisions, std::span<const std::size_t> class_of_contact, std::size_t classes,
          std::span<const Candidate> candidates, const PlanOptions& options)
      : collisions_(collisions), class_of_contact_(class_of_contact), candidates_(candidates), options_(options) {
    ClassTally empty;
    for (const Law law : lesser_laws(options.demand.law)) {
      empty.laws.push_back({law});
    }
    empty.certificates.resize(candidates.size());
    tallies_.assign(std::max(1U, options.workers.count), std::vector<ClassTally>(classes, empty));
  }

  /// Returns one tally for each class. Throws std::runtime_error if a stop is requested.
  std::vector<ClassTally> run() {
    options_.workers.run(tallies_.size(), [&](std::size_t worker) {
      try {
        judge_blocks(tallies_[worker]);
      } catch (...) {
        next_ = collisions_.size();
        throw;
      }
    });
    if (options_.stop.stop_requested()) {
      throw std::runtime_error("stopped by the user");
    }
    std::vector<ClassTally> sum = tallies_.front();
    for (std::size_t thread = 1; thread < tallies_.size(); ++thread) {
      for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += tallies_[thread][i];
      }
    }
    return sum;
  }

 private:
  void judge_blocks(std::vector<ClassTally>& tallies) {
    std::vector<Session> sessions;
    for (const Candidate& candidate : candidates_) {
      sessions.push_back(candidate.subject.open());
    }
    for (std::size_t first = next_.fetch_add(block_size); first < collisions_.size() && !options_.stop.stop_requested();
         first = next_.fetch_add(block_size)) {
      const auto block = collisions_.subspan(first, std::min(block_size, collisions_.size() - first));
      std::vector<std::vector<Answer>> answers;
      for (Session& session : sessions) {
        answers.push_back(answers_of(session, block));
      }
      for (std::size_t i = 0; i < block.size(); ++i) {
        judge_contact(first + i, answers, i, tallies[class_of_contact_[first + i]]);
      }
      show_progress(block.size());
    }
  }

  void judge_contact(std::size_t contact, const std::vector<std::vector<Answer>>& answers, std::size_t in_block,
                     ClassTally& tally) {
    const Certifier certifier(collisions_[contact], options_.demand);
    tally.colliding += certifier.collides() ? 1 : 0;
    for (LawCount& count : tally.laws) {
      if (const auto reason = reduction(certifier.exact(), options_.demand.law, count.law)) {
        ++count.by_reason[*reason];
      }
    }
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      tally.certificates[c].add(contact, certifier.judge(candidates_[c], answers[c][in_block]));
    }
  }

  void show_progress(std::size_t more) {
    const std::lock_guard lock(mutex_);
    done_ += more;
    if (options_.progress) {
      options_.progress(done_, collisions_.size());
    }
  }

  std::span<const Collision> collisions_;
  std::span<const std::size_t> class_of_contact_;
  std::span<const Candidate> candidates_;
  const PlanOptions& options_;
  std::vector<std::vector<ClassTally>> tallies_;  // by thread, then by class
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::uint64_t done_ = 0;
};

Part part_of(std::string name, std::vector<std::size_t> contacts, const ClassTally& tally, const Demand& demand,
             std::span<const Candidate> candidates) {
  Part part;
  part.name = std::move(name);
  part.contacts = std::move(contacts);
  part.colliding = tally.colliding;
  part.laws = tally.laws;
  for (std::size_t c = 0; c < tally.certificates.size(); ++c) {
    JudgedCandidate judged{c, tally.certificates[c], std::nullopt};
    const bool is_same_law = part.count_of(candidates[c].subject.law).exactly() == part.contacts.size();
    judged.serves = judged.certificate.serves() && (!demand.exact_law || is_same_law);
    LawCount& count = *std::ranges::find(part.laws, candidates[c].subject.law, &LawCount::law);
    count.served = std::max(count.served, judged.certificate.contacts - judged.certificate.failures);
    part.candidates.push_back(std::move(judged));
  }
  return part;
}

/// A candidate may be chosen if it serves, and if no serving candidate has less precision and is the same otherwise.
bool may_be_least(const Part& part, const JudgedCandidate& one, std::span<const Candidate> candidates) {
  return one.serves && std::ranges::none_of(part.candidates, [&](const JudgedCandidate& other) {
           const Candidate& x = candidates[other.candidate];
           const Candidate& y = candidates[one.candidate];
           return other.serves && differ_in_precision_alone(x, y) && x.scalar_rank < y.scalar_rank;
         });
}

std::vector<Collision> sample_of(const Part& part, std::span<const Collision> collisions) {
  const std::size_t count = std::min(part.contacts.size(), contacts_timed);
  std::vector<Collision> sample;
  for (std::size_t i = 0; i < count; ++i) {
    sample.push_back(collisions[part.contacts[i * part.contacts.size() / count]]);
  }
  return sample;
}

void measure(std::span<Part* const> parts, std::span<const Collision> collisions, std::span<const Candidate> candidates,
             std::size_t baseline, const Clock& clock) {
  std::vector<std::vector<Collision>> samples;
  for (const Part* part : parts) {
    samples.push_back(sample_of(*part, collisions));
  }
  std::vector<Timing> timings;
  std::vector<std::optional<double>*> into;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (JudgedCandidate& one : parts[p]->candidates) {
      if (one.candidate == baseline || may_be_least(*parts[p], one, candidates)) {
        timings.push_back({&candidates[one.candidate], samples[p]});
        into.push_back(&one.nanoseconds);
      }
    }
    parts[p]->timed_contacts = samples[p].size();
  }
  const std::vector<double> times = clock(timings);
  for (std::size_t i = 0; i < times.size(); ++i) {
    *into[i] = times[i];
  }
  for (Part* part : parts) {
    part->baseline_nanoseconds = part->candidates[baseline].nanoseconds;
  }
}

std::optional<std::size_t> least(const Part& part, std::span<const Candidate> candidates, bool in_batches) {
  std::vector<std::size_t> open;
  std::optional<double> quickest;
  for (std::size_t i = 0; i < part.candidates.size(); ++i) {
    const JudgedCandidate& one = part.candidates[i];
    if (candidates[one.candidate].is_batch == in_batches && may_be_least(part, one, candidates)) {
      open.push_back(i);
      quickest = one.nanoseconds ? std::min(quickest.value_or(*one.nanoseconds), *one.nanoseconds) : quickest;
    }
  }
  if (quickest) {
    std::erase_if(open, [&](std::size_t i) { return *part.candidates[i].nanoseconds > times_alike * *quickest; });
  }
  const auto found = std::ranges::min_element(open, [&](std::size_t x, std::size_t y) {
    return is_less(candidates[part.candidates[x].candidate], candidates[part.candidates[y].candidate]);
  });
  return found == open.end() ? std::nullopt : std::optional<std::size_t>(*found);
}

std::size_t baseline_of(std::span<const Candidate> candidates, Law law) {
  const std::string name = std::string(name_of(law)) + "-double";
  const auto found =
      std::ranges::find_if(candidates, [&](const Candidate& candidate) { return candidate.subject.name == name; });
  if (found == candidates.end()) {
    throw std::invalid_argument("a plan needs " + name + " to compare with");
  }
  return static_cast<std::size_t>(found - candidates.begin());
}

struct Classified {
  std::vector<Collision> collisions;
  std::vector<std::size_t> class_of_contact;
  std::vector<std::string> names;  // of the classes
};

/// Leaves out contacts without a law, and adds all findings to the plan. Throws std::invalid_argument for any other
/// invalid collision.
Classified classified(std::span<const ClassedCollision> contacts, Plan& plan) {
  Classified result;
  for (const ClassedCollision& contact : contacts) {
    const bool is_left_out = is_out_of_range(contact.collision);
    if (const std::vector<InputError> errors = validate(contact.collision); !is_left_out && !errors.empty()) {
      throw std::invalid_argument(contact.place + ": " + describe(errors));
    }
    std::ranges::move(findings_of(contact), std::back_inserter(plan.findings));
    if (is_left_out) {
      ++plan.left_out;
      continue;
    }
    const std::string name =
        contact.contact_class.empty() ? contact_class_of(contact.collision) : contact.contact_class;
    auto found = std::ranges::find(result.names, name);
    if (found == result.names.end()) {
      found = result.names.insert(result.names.end(), name);
    }
    result.class_of_contact.push_back(static_cast<std::size_t>(found - result.names.begin()));
    result.collisions.push_back(contact.collision);
    plan.places.push_back(contact.place);
  }
  return result;
}

}  // namespace

std::size_t LawCount::exactly() const { return std::accumulate(by_reason.begin(), by_reason.end(), std::size_t{0}); }

double Part::saving_of(const JudgedCandidate& candidate) const {
  CAROM_EXPECTS(baseline_nanoseconds && candidate.nanoseconds);
  return *baseline_nanoseconds / *candidate.nanoseconds;
}

const LawCount& Part::count_of(Law law) const { return *std::ranges::find(laws, law, &LawCount::law); }

bool Plan::serves() const { return whole.one_at_a_time || whole.in_batches; }

std::optional<double> Plan::saving_by_class(bool in_batches) const {
  double before = 0;
  double after = 0;
  for (const Part& part : classes) {
    const std::optional<std::size_t>& choice = in_batches ? part.in_batches : part.one_at_a_time;
    if (!choice || !part.candidates[*choice].nanoseconds) {
      return std::nullopt;
    }
    const auto contacts = static_cast<double>(part.contacts.size());
    before += contacts * *part.baseline_nanoseconds;
    after += contacts * *part.candidates[*choice].nanoseconds;
  }
  return after > 0 ? std::optional<double>(before / after) : std::nullopt;
}

Plan make_plan(std::span<const ClassedCollision> contacts, std::span<const Candidate> candidates,
               const PlanOptions& options) {
  if (contacts.empty()) {
    throw std::invalid_argument("a plan needs at least one contact");
  }
  if (options.demand.law == Law::any) {
    throw std::invalid_argument("a plan needs one law, not `any`");
  }
  Plan plan;
  std::ranges::copy_if(candidates, std::back_inserter(plan.candidates), [&](const Candidate& candidate) {
    return std::ranges::count(lesser_laws(options.demand.law), candidate.subject.law) > 0;
  });
  const std::size_t baseline = baseline_of(plan.candidates, options.demand.law);
  const Classified served = classified(contacts, plan);
  if (served.collisions.empty()) {
    return plan;
  }
  const std::vector<ClassTally> tallies =
      Judging(served.collisions, served.class_of_contact, served.names.size(), plan.candidates, options).run();
  std::vector<std::vector<std::size_t>> contacts_of_class(served.names.size());
  for (std::size_t i = 0; i < served.class_of_contact.size(); ++i) {
    contacts_of_class[served.class_of_contact[i]].push_back(i);
  }
  ClassTally of_all = tallies.front();
  for (std::size_t i = 0; i < served.names.size(); ++i) {
    if (i > 0) {
      of_all += tallies[i];
    }
    plan.classes.push_back(
        part_of(served.names[i], std::move(contacts_of_class[i]), tallies[i], options.demand, plan.candidates));
  }
  std::vector<std::size_t> all(served.collisions.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  plan.whole = part_of("the whole", std::move(all), of_all, options.demand, plan.candidates);
  std::vector<Part*> parts{&plan.whole};
  for (Part& part : plan.classes) {
    parts.push_back(&part);
  }
  if (options.clock) {
    measure(parts, served.collisions, plan.candidates, baseline, options.clock);
  }
  for (Part* part : parts) {
    for (const std::size_t contact : part->contacts) {
      ++part->torque_forms[torque_form_of(served.collisions[contact])];
    }
    part->one_at_a_time = least(*part, plan.candidates, false);
    part->in_batches = least(*part, plan.candidates, true);
  }
  return plan;
}

}  // namespace carom::properties::plan
