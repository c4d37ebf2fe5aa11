// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <carom/properties/trial/declared_effects.hpp>
#include <carom/report/model/comparison.hpp>
#include <carom/report/model/run.hpp>
#include <carom/report/model/words.hpp>

namespace carom::report {
namespace {

using properties::Count;

std::vector<std::string> all_shown(std::vector<std::string> texts) {
  for (std::string& text : texts) {
    text = shown(text);
  }
  return texts;
}

RunHeading heading_of(const Run& run, const std::string& file) {
  const std::optional<properties::Shard>& shard = run.settings.shard;
  return {shown(file),
          shown(run.carom),
          shown(run.environment.date),
          run.settings.seed,
          run.settings.cases,
          run.families.size(),
          shard ? fmt::format("{}/{}", shard->number, shard->of) : ""};
}

SubjectSummary summary_of(const Subject& subject, const std::string& status, const std::string& error) {
  SubjectSummary summary;
  summary.status = shown(status);
  summary.error = shown(error);
  summary.version = shown(subject.version);
  summary.law = name_of(subject.law);
  summary.precision = name_of(subject.precision);
  summary.deviates = all_shown(subject.deviates);
  return summary;
}

SubjectSummary summary_of(const JudgedSubject& judged_subject) {
  const properties::SubjectResult& result = judged_subject.result;
  SubjectSummary summary = summary_of(result.subject, judged_subject.status, judged_subject.why_not_judged());
  summary.cases = result.cases();
  for (const properties::FamilyResult& family : result.families) {
    summary.violated_cases += family.violated;
  }
  for (const Violation& violation : judged_subject.violations) {
    summary.violated.push_back(shown(violation.invariant));
  }
  if (determines_outcome(result.subject.law)) {
    summary.worst_backward_error = judged_subject.worst.backward_error;
    summary.worst_family = shown(judged_subject.worst.family);
  }
  summary.digits = judged_subject.digits;
  return summary;
}

/// A subject of a report. An absent subject is one that is not installed.
struct OneSubject {
  const Run* run;
  const Subject* subject;
  const JudgedSubject* judged;  // none for an absent subject

  [[nodiscard]] SubjectSummary summary() const {
    return judged != nullptr ? summary_of(*judged) : summary_of(*subject, "absent", subject->absent);
  }
  [[nodiscard]] bool counts() const { return judged != nullptr && judged->counts; }
  [[nodiscard]] std::optional<std::vector<std::string>> not_claimed() const {
    return judged != nullptr ? judged->not_claimed : not_claimed_by(*subject);
  }
};

std::vector<OneSubject> subjects_of(const Run& run) {
  std::vector<OneSubject> subjects;
  for (const JudgedSubject& judged : run.subjects) {
    subjects.push_back({&run, &judged.result.subject, &judged});
  }
  for (const Subject& absent : run.absent) {
    subjects.push_back({&run, &absent, nullptr});
  }
  return subjects;
}

std::string or_none(const std::optional<std::uint64_t>& number, const char* none) {
  return number ? std::to_string(*number) : none;
}

std::string cases_in_words(const Settings& settings) {
  return settings.budget_seconds ? fmt::format("as many as possible in {} s", *settings.budget_seconds)
                                 : or_none(settings.cases, "unknown");
}

std::string limits_in_words(const oracles::Limits& limits) {
  return limit_in_words(limits) + (limits.filtered ? "" : ", only in exact arithmetic");
}

std::vector<std::string> families_of(const Run& run) {
  std::vector<std::string> names;
  for (const RunFamily& family : run.families) {
    names.push_back(shown(family.name));
  }
  return names;
}

std::string list_of(const std::vector<std::string>& words) { return words.empty() ? "none" : listed(words); }

std::vector<std::string> without(const std::vector<std::string>& words, const std::vector<std::string>& others) {
  std::vector<std::string> rest;
  std::copy_if(words.begin(), words.end(), std::back_inserter(rest),
               [&](const std::string& word) { return std::find(others.begin(), others.end(), word) == others.end(); });
  return rest;
}

const OneSubject* found_in(const std::vector<OneSubject>& subjects, const Subject& wanted) {
  const auto of = [&](const auto& is_it) {
    const auto found =
        std::find_if(subjects.begin(), subjects.end(), [&](const OneSubject& one) { return is_it(*one.subject); });
    return found == subjects.end() ? nullptr : &*found;
  };
  if (const OneSubject* same = of([&](const Subject& subject) { return subject.name == wanted.name; })) {
    return same;
  }
  // A program states its name when it starts. If it could not be started, only the specification identifies it.
  return wanted.specification.empty()
             ? nullptr
             : of([&](const Subject& subject) { return subject.specification == wanted.specification; });
}

/// The counts of the subject's invariants, by the families of its run.
std::map<std::string, std::map<std::string, Count>> counts_of(const OneSubject* subject) {
  std::map<std::string, std::map<std::string, Count>> counts;
  if (subject != nullptr && subject->judged != nullptr) {
    const auto& families = subject->judged->result.families;
    for (std::size_t f = 0; f < families.size(); ++f) {
      counts[subject->run->families[f].name] = families[f].counts;
    }
  }
  return counts;
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

/// The families of the newer run, followed by those that only the older run has, and the invariants of both runs.
struct Names {
  std::vector<std::string> families;
  std::set<std::string> invariants;
};

Names names_of(const OneSubject* before, const OneSubject* now) {
  Names names;
  for (const OneSubject* subject : {now, before}) {
    if (subject == nullptr || subject->judged == nullptr) {
      continue;
    }
    const auto& families = subject->judged->result.families;
    for (std::size_t f = 0; f < families.size(); ++f) {
      const std::string& name = subject->run->families[f].name;
      if (std::find(names.families.begin(), names.families.end(), name) == names.families.end()) {
        names.families.push_back(name);
      }
      for (const auto& [invariant, count] : families[f].counts) {
        names.invariants.insert(invariant);
      }
    }
  }
  return names;
}

bool cannot_be_judged(const SubjectSummary& summary) {
  return summary.status == "error" || summary.status == "not judged";
}

std::size_t count_in(const ComparedSubject& subject, Change change) {
  return static_cast<std::size_t>(
      std::count_if(subject.violations.begin(), subject.violations.end(),
                    [&](const ComparedViolation& violation) { return violation.change == change; }));
}

/// Compares one subject of both reports. nullptr means that a report lacks it. Precondition: at most one is nullptr.
ComparedSubject compare_subjects(const OneSubject* before, const OneSubject* now) {
  ComparedSubject subject;
  subject.name = shown((now != nullptr ? now : before)->subject->name);
  subject.counts = now != nullptr && now->counts();
  if (before != nullptr) {
    subject.before = before->summary();
  }
  if (now != nullptr) {
    subject.now = now->summary();
  }
  if (before != nullptr && now != nullptr) {
    subject.no_longer_claimed = without(subject.now->deviates, subject.before->deviates);
    if (const std::string effects = properties::to_text(now->subject->effects);
        !effects.empty() && effects != properties::to_text(before->subject->effects)) {
      subject.no_longer_claimed.push_back("the law without " + effects);
    }
    const auto of_matrix = now->not_claimed();
    const auto of_matrix_before = before->not_claimed();
    if (of_matrix && of_matrix_before) {
      const std::vector<std::string> more = all_shown(without(*of_matrix, *of_matrix_before));
      subject.no_longer_claimed.insert(subject.no_longer_claimed.end(), more.begin(), more.end());
    }
  }
  subject.cannot_be_judged_now =
      subject.now && cannot_be_judged(*subject.now) && !(subject.before && cannot_be_judged(*subject.before));
  auto old_counts = counts_of(before);
  auto new_counts = counts_of(now);
  const Names names = names_of(before, now);
  for (const std::string& invariant : names.invariants) {
    for (const std::string& family : names.families) {
      const Count old_count = old_counts[family][invariant];
      const Count new_count = new_counts[family][invariant];
      if (const std::optional<Change> change = change_of(old_count, new_count)) {
        subject.violations.push_back({*change, shown(invariant), shown(family), old_count, new_count});
      }
    }
  }
  return subject;
}

std::vector<Difference> differences_between(const Run& before, const Run& now) {
  std::vector<Difference> differences;
  const auto note = [&](const char* what, const std::string& old_value, const std::string& new_value) {
    if (old_value != new_value) {
      differences.push_back({what, old_value, new_value});
    }
  };
  const auto cut_short = [](const Run& run) -> std::string {
    return run.interrupted          ? "interrupted"
           : run.settings.fail_fast ? "after the first violation of each subject"
                                    : "no";
  };
  const auto relations = [](const Run& run) {
    return run.settings.relations_every > 0 ? std::to_string(run.settings.relations_every) : "default";
  };
  const auto part = [](const Run& run) {
    const std::string shard = heading_of(run, "").shard;
    return shard.empty() ? "the whole run" : shard;
  };
  note("version of Carom", shown(before.carom), shown(now.carom));
  note("seed", std::to_string(before.settings.seed), std::to_string(now.settings.seed));
  note("cases of each family", cases_in_words(before.settings), cases_in_words(now.settings));
  const std::vector<std::string> gone = without(families_of(before), families_of(now));
  const std::vector<std::string> added = without(families_of(now), families_of(before));
  if (!gone.empty() || !added.empty()) {
    differences.push_back({"families of one run only", list_of(gone), list_of(added)});
  }
  note("domain", to_text(before.settings.within), to_text(now.settings.within));
  note("yardstick", limits_in_words(before.settings.limits), limits_in_words(now.settings.limits));
  note("interval between the cases on which relations are judged", relations(before), relations(now));
  note("ended early", cut_short(before), cut_short(now));
  note("shard", part(before), part(now));
  return differences;
}

}  // namespace

std::string_view in_words(Change change) {
  switch (change) {
    case Change::newly_violated:
      return "new";
    case Change::violated_unknown:
      return "new, not judged before";
    case Change::known:
      return "known";
    case Change::fixed:
      return "fixed";
    case Change::no_longer_judged:
      break;
  }
  return "no longer judged";
}

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

Comparison compare_runs(const Run& before, const std::string& file_before, const Run& now,
                        const std::string& file_now) {
  Comparison comparison{
      heading_of(before, file_before), heading_of(now, file_now), differences_between(before, now), {}};
  const std::vector<OneSubject> old_subjects = subjects_of(before);
  std::set<const OneSubject*> met;
  for (const OneSubject& subject : subjects_of(now)) {
    const OneSubject* old_subject = found_in(old_subjects, *subject.subject);
    if (old_subject != nullptr && !met.insert(old_subject).second) {
      old_subject = nullptr;
    }
    comparison.subjects.push_back(compare_subjects(old_subject, &subject));
  }
  for (const OneSubject& subject : old_subjects) {
    if (!met.contains(&subject)) {
      comparison.subjects.push_back(compare_subjects(&subject, nullptr));
    }
  }
  return comparison;
}

bool is_known(const Comparison& comparison, const std::string& subject, const std::string& invariant) {
  bool any = false;
  for (const ComparedSubject& one : comparison.subjects) {
    if (one.name != shown(subject)) {
      continue;
    }
    for (const ComparedViolation& violation : one.violations) {
      if (violation.invariant == invariant) {
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
