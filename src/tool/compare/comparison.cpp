// SPDX-License-Identifier: BSL-1.0
#include "compare/comparison.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/collision/expects.hpp>

namespace carom::tool::compare {
namespace {

std::string or_none(const std::optional<std::uint64_t>& number, const char* none) {
  return number ? std::to_string(*number) : none;
}

std::string extent_of(const ReadReport& report) {
  return report.budget ? fmt::format("as many as {} s allow", *report.budget) : or_none(report.cases, "unknown");
}

std::string list_of(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

/// The words of the first list that the second has not.
std::vector<std::string> without(const std::vector<std::string>& words, const std::vector<std::string>& others) {
  std::vector<std::string> rest;
  std::copy_if(words.begin(), words.end(), std::back_inserter(rest),
               [&](const std::string& word) { return std::find(others.begin(), others.end(), word) == others.end(); });
  return rest;
}

const ReadSubject* found_in(const ReadReport& report, const ReadSubject& wanted) {
  const auto of = [&](const auto& is_it) {
    const auto found = std::find_if(report.subjects.begin(), report.subjects.end(), is_it);
    return found == report.subjects.end() ? nullptr : &*found;
  };
  if (const ReadSubject* same = of([&](const ReadSubject& subject) { return subject.name == wanted.name; })) {
    return same;
  }
  // A program that could not be started has not said its name.
  return wanted.specification.empty()
             ? nullptr
             : of([&](const ReadSubject& subject) { return subject.specification == wanted.specification; });
}

ReadCount count_in(const ReadSubject* subject, const std::string& family, const std::string& invariant) {
  if (subject == nullptr) {
    return {};
  }
  const auto found = std::find_if(subject->families.begin(), subject->families.end(),
                                  [&](const ReadFamily& one) { return one.name == family; });
  if (found == subject->families.end()) {
    return {};
  }
  const auto count = found->invariants.find(invariant);
  return count == found->invariants.end() ? ReadCount{} : count->second;
}

std::optional<Change> change_of(const ReadCount& before, const ReadCount& now) {
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

/// Names of families and invariants of either, each once.
struct Names {
  std::vector<std::string> families;
  std::set<std::string> invariants;
};

Names names_of(const ReadSubject* before, const ReadSubject* now) {
  Names names;
  for (const ReadSubject* subject : {now, before}) {
    if (subject == nullptr) {
      continue;
    }
    for (const ReadFamily& family : subject->families) {
      if (std::find(names.families.begin(), names.families.end(), family.name) == names.families.end()) {
        names.families.push_back(family.name);
      }
      for (const auto& [invariant, count] : family.invariants) {
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

/// One subject of both reports; nullptr where one has it not. Precondition: not both.
ComparedSubject compare_subjects(const ReadSubject* before, const ReadSubject* now) {
  CAROM_EXPECTS(before != nullptr || now != nullptr);
  ComparedSubject subject;
  subject.name = (now != nullptr ? now : before)->name;
  subject.counts = now != nullptr && now->counts;
  if (before != nullptr) {
    subject.before = before->summary;
  }
  if (now != nullptr) {
    subject.now = now->summary;
  }
  if (before != nullptr && now != nullptr) {
    subject.no_longer_claimed = without(now->summary.deviates, before->summary.deviates);
    if (before->summary.not_claimed && now->summary.not_claimed) {
      const std::vector<std::string> more = without(*now->summary.not_claimed, *before->summary.not_claimed);
      subject.no_longer_claimed.insert(subject.no_longer_claimed.end(), more.begin(), more.end());
    }
  }
  subject.cannot_be_judged_now =
      now != nullptr && cannot_be_judged(now->summary) && (before == nullptr || !cannot_be_judged(before->summary));
  const Names names = names_of(before, now);
  for (const std::string& invariant : names.invariants) {
    for (const std::string& family : names.families) {
      const ReadCount old_count = count_in(before, family, invariant);
      const ReadCount new_count = count_in(now, family, invariant);
      if (const std::optional<Change> change = change_of(old_count, new_count)) {
        subject.violations.push_back({*change, invariant, family, old_count, new_count});
      }
    }
  }
  return subject;
}

/// The settings in which the runs differ.
std::vector<Difference> differences_between(const ReadReport& before, const ReadReport& now) {
  std::vector<Difference> differences;
  const auto note = [&](const char* what, const std::string& old_value, const std::string& new_value) {
    if (old_value != new_value) {
      differences.push_back({what, old_value, new_value});
    }
  };
  const auto cut_short = [](const ReadReport& report) -> std::string {
    return report.interrupted ? "interrupted" : report.fail_fast ? "at the first violation of each subject" : "not";
  };
  note("version of Carom", before.carom, now.carom);
  note("seed", std::to_string(before.seed), std::to_string(now.seed));
  note("cases of each family", extent_of(before), extent_of(now));
  const std::vector<std::string> gone = without(before.families, now.families);
  const std::vector<std::string> added = without(now.families, before.families);
  if (!gone.empty() || !added.empty()) {
    differences.push_back({"families that the other has not", list_of(gone), list_of(added)});
  }
  note("yardstick", before.yardstick, now.yardstick);
  note("relations judged on every so many cases", or_none(before.relations_every, "as is the default"),
       or_none(now.relations_every, "as is the default"));
  note("cut short", cut_short(before), cut_short(now));
  note("shard", before.shard.empty() ? "the whole" : before.shard, now.shard.empty() ? "the whole" : now.shard);
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

Comparison compare_reports(ReadReport before, ReadReport now) {
  Comparison comparison{std::move(before), std::move(now), {}, {}};
  comparison.differences = differences_between(comparison.before, comparison.now);
  std::set<const ReadSubject*> met;
  for (const ReadSubject& subject : comparison.now.subjects) {
    const ReadSubject* old_subject = found_in(comparison.before, subject);
    if (old_subject != nullptr && !met.insert(old_subject).second) {
      old_subject = nullptr;
    }
    comparison.subjects.push_back(compare_subjects(old_subject, &subject));
  }
  for (const ReadSubject& subject : comparison.before.subjects) {
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
    text += fmt::format(" in what counts ({} in what does not)", all - counting);
  }
  return text + fmt::format(", {} known, {} fixed", comparison.count(Change::known), comparison.count(Change::fixed));
}

}  // namespace carom::tool::compare
