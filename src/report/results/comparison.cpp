// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

#include <carom/report/results/comparison.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using properties::Count;

std::string list_of(const std::vector<std::string>& words) { return words.empty() ? "none" : listed(words); }

std::vector<std::string> without(const std::vector<std::string>& words, const std::vector<std::string>& others) {
  std::vector<std::string> rest;
  std::copy_if(words.begin(), words.end(), std::back_inserter(rest),
               [&](const std::string& word) { return std::find(others.begin(), others.end(), word) == others.end(); });
  return rest;
}

const RecordedSubject* found_in(const std::vector<RecordedSubject>& subjects, const RecordedSubject& wanted) {
  const auto of = [&](const auto& is_it) {
    const auto found = std::find_if(subjects.begin(), subjects.end(), is_it);
    return found == subjects.end() ? nullptr : &*found;
  };
  if (const RecordedSubject* same = of([&](const RecordedSubject& subject) { return subject.name == wanted.name; })) {
    return same;
  }
  // A program states its name when it starts. If it could not be started, only the specification identifies it.
  return wanted.specification.empty()
             ? nullptr
             : of([&](const RecordedSubject& subject) { return subject.specification == wanted.specification; });
}

std::optional<Change> change_of(const Count& before, const Count& now) {
  if (now.violated > 0) {
    if (before.violated > 0) {
      return Change::known;
    }
    return before.judged() > 0 ? Change::newly_violated : Change::violated_unknown;
  }
  if (before.violated > 0) {
    return now.judged() > 0 ? Change::fixed : Change::no_longer_judged;
  }
  return std::nullopt;
}

/// The counts of both subjects by invariant. The families are those of the newer run, followed by those that only the
/// older run has.
struct BothCounts {
  std::vector<std::string> families;
  std::set<std::string> invariants;
  std::map<std::pair<std::string, std::string>, std::pair<Count, Count>> counts;  // by invariant and family
};

BothCounts counts_of(const RecordedSubject* before, const RecordedSubject* now) {
  BothCounts both;
  const auto add = [&](const RecordedSubject* subject, Count std::pair<Count, Count>::*of_one) {
    for (const RecordedFamily& family : subject == nullptr ? std::span<const RecordedFamily>() : subject->families) {
      if (std::find(both.families.begin(), both.families.end(), family.name) == both.families.end()) {
        both.families.push_back(family.name);
      }
      for (const auto& [invariant, count] : family.counts) {
        both.invariants.insert(invariant);
        both.counts[{invariant, family.name}].*of_one = count;
      }
    }
  };
  add(now, &std::pair<Count, Count>::second);
  add(before, &std::pair<Count, Count>::first);
  return both;
}

bool cannot_be_judged(const RecordedSubject& subject) {
  return subject.status == SubjectStatus::error || subject.status == SubjectStatus::not_judged;
}

std::size_t count_in(const ComparedSubject& subject, Change change) {
  return static_cast<std::size_t>(
      std::count_if(subject.violations.begin(), subject.violations.end(),
                    [&](const ComparedViolation& violation) { return violation.change == change; }));
}

/// Compares one subject of both reports. nullptr means that a report lacks it. Precondition: at most one is nullptr.
ComparedSubject compare_subjects(const RecordedSubject* before, const RecordedSubject* now) {
  ComparedSubject subject;
  subject.name = (now != nullptr ? now : before)->name;
  subject.counts = now != nullptr && now->counts;
  subject.was_before = before != nullptr;
  subject.is_now = now != nullptr;
  if (before != nullptr && now != nullptr) {
    subject.no_longer_claimed = without(now->deviates, before->deviates);
    if (!now->effects.empty() && now->effects != before->effects) {
      subject.no_longer_claimed.push_back("the law without " + now->effects);
    }
    if (now->not_claimed && before->not_claimed) {
      const std::vector<std::string> more = without(*now->not_claimed, *before->not_claimed);
      subject.no_longer_claimed.insert(subject.no_longer_claimed.end(), more.begin(), more.end());
    }
  }
  subject.cannot_be_judged_now =
      now != nullptr && cannot_be_judged(*now) && !(before != nullptr && cannot_be_judged(*before));
  subject.error = subject.cannot_be_judged_now ? now->error : "";
  const BothCounts both = counts_of(before, now);
  for (const std::string& invariant : both.invariants) {
    for (const std::string& family : both.families) {
      const auto found = both.counts.find({invariant, family});
      if (found == both.counts.end()) {
        continue;
      }
      const auto& [old_count, new_count] = found->second;
      if (const std::optional<Change> change = change_of(old_count, new_count)) {
        subject.violations.push_back({*change, invariant, family, old_count, new_count});
      }
    }
  }
  return subject;
}

std::vector<Difference> differences_between(const RecordedRun& before, const RecordedRun& now) {
  std::vector<Difference> differences;
  const auto note = [&](const char* what, const std::string& old_value, const std::string& new_value) {
    if (old_value != new_value) {
      differences.push_back({what, old_value, new_value});
    }
  };
  note("version of Carom", before.heading.carom, now.heading.carom);
  note("seed", std::to_string(before.heading.seed), std::to_string(now.heading.seed));
  note("cases of each family", before.cases, now.cases);
  const std::vector<std::string> gone = without(before.families, now.families);
  const std::vector<std::string> added = without(now.families, before.families);
  if (!gone.empty() || !added.empty()) {
    differences.push_back({"families of one run only", list_of(gone), list_of(added)});
  }
  note("domain", before.domain, now.domain);
  note("yardstick", before.yardstick, now.yardstick);
  note("interval between the cases on which relations are judged", before.relations_every, now.relations_every);
  note("ended early", before.ended_early, now.ended_early);
  note("shard", before.shard, now.shard);
  return differences;
}

nlohmann::json count_record(const Count& count) { return {{"holds", count.holds}, {"violated", count.violated}}; }

/// The violations with these changes. A subject that can no longer be judged has no invariant, so it is not listed.
nlohmann::json violations_record(const Comparison& comparison, std::initializer_list<Change> changes) {
  nlohmann::json list = nlohmann::json::array();
  for (const ComparedSubject& subject : comparison.subjects) {
    for (const ComparedViolation& violation : subject.violations) {
      if (std::find(changes.begin(), changes.end(), violation.change) != changes.end()) {
        list.push_back({{"subject", subject.name},
                        {"invariant", violation.invariant},
                        {"family", violation.family},
                        {"counts", subject.counts},
                        {"judged_before", violation.before.judged() > 0},
                        {"before", count_record(violation.before)},
                        {"now", count_record(violation.now)}});
      }
    }
  }
  return list;
}

nlohmann::json subject_names(const Comparison& comparison, bool (*is_listed)(const ComparedSubject&)) {
  nlohmann::json list = nlohmann::json::array();
  for (const ComparedSubject& subject : comparison.subjects) {
    if (is_listed(subject)) {
      list.push_back(subject.name);
    }
  }
  return list;
}

}  // namespace

bool is_new(Change change) { return change == Change::newly_violated || change == Change::violated_unknown; }

std::size_t Comparison::count_new(bool counting_alone) const {
  std::size_t sum = 0;
  for (const ComparedSubject& subject : subjects) {
    if (subject.counts || !counting_alone) {
      sum += count_in(subject, Change::newly_violated) + count_in(subject, Change::violated_unknown) +
             (subject.cannot_be_judged_now ? 1 : 0);
    }
  }
  return sum;
}

std::size_t Comparison::count(Change change) const {
  std::size_t sum = 0;
  for (const ComparedSubject& subject : subjects) {
    sum += count_in(subject, change);
  }
  return sum;
}

Comparison compare_runs(const RecordedRun& before, const RecordedRun& now) {
  Comparison comparison{before.heading, differences_between(before, now), {}};
  std::set<const RecordedSubject*> met;
  for (const RecordedSubject& subject : now.subjects) {
    const RecordedSubject* old_subject = found_in(before.subjects, subject);
    if (old_subject != nullptr && !met.insert(old_subject).second) {
      old_subject = nullptr;
    }
    comparison.subjects.push_back(compare_subjects(old_subject, &subject));
  }
  for (const RecordedSubject& subject : before.subjects) {
    if (!met.contains(&subject)) {
      comparison.subjects.push_back(compare_subjects(&subject, nullptr));
    }
  }
  return comparison;
}

nlohmann::json baseline_record(const Comparison& comparison) {
  nlohmann::json differences = nlohmann::json::array();
  for (const Difference& difference : comparison.differences) {
    differences.push_back({{"what", difference.what}, {"before", difference.before}, {"now", difference.now}});
  }
  const RunHeading& report = comparison.before;
  return {{"report",
           {{"file", report.file},
            {"carom", report.carom},
            {"date", report.date},
            {"seed", report.seed},
            {"cases_of_each_family", report.cases ? nlohmann::json(*report.cases) : nlohmann::json()}}},
          {"comparable", comparison.differences.empty()},
          {"differences", std::move(differences)},
          {"new", violations_record(comparison, {Change::newly_violated, Change::violated_unknown})},
          {"known", violations_record(comparison, {Change::known})},
          {"fixed", violations_record(comparison, {Change::fixed})},
          {"no_longer_judged", violations_record(comparison, {Change::no_longer_judged})},
          {"cannot_be_judged_now", subject_names(comparison, [](const auto& one) { return one.cannot_be_judged_now; })},
          {"came", subject_names(comparison, [](const auto& one) { return !one.was_before; })},
          {"went", subject_names(comparison, [](const auto& one) { return !one.is_now; })}};
}

bool is_known(const Comparison& comparison, const std::string& subject, const properties::Invariant& invariant) {
  bool any = false;
  for (const ComparedSubject& one : comparison.subjects) {
    if (one.name != shown(subject)) {
      continue;
    }
    for (const ComparedViolation& violation : one.violations) {
      if (violation.invariant == invariant.name) {
        if (is_new(violation.change)) {
          return false;
        }
        any = any || violation.change == Change::known;
      }
    }
  }
  return any;
}

std::string summary_of(const Comparison& comparison) {
  std::string text = fmt::format("{} new, {} known, {} fixed", comparison.count_new(false),
                                 comparison.count(Change::known), comparison.count(Change::fixed));
  if (const std::size_t lost = comparison.count(Change::no_longer_judged); lost > 0) {
    text += fmt::format(", {} no longer judged", lost);
  }
  return text;
}

std::string baseline_verdict(const Comparison& comparison) {
  const std::size_t all = comparison.count_new(false);
  const std::size_t counting = comparison.count_new(true);
  std::string text = counting == 0 ? "nothing new" : fmt::format("{} new", counting);
  if (all > counting) {
    text += fmt::format(" in subjects that count ({} in others)", all - counting);
  }
  return text + fmt::format(", {} known, {} fixed", comparison.count(Change::known), comparison.count(Change::fixed));
}

}  // namespace carom::report
