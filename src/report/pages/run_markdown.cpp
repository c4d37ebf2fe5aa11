// SPDX-License-Identifier: BSL-1.0
#include <fmt/format.h>

#include <carom/report/model/version.hpp>
#include <carom/report/model/words.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/pages/parts.hpp>

namespace carom::report {
namespace {

constexpr std::size_t longest_page = 1'000'000;
constexpr int level = 3;  // of a subject's heading

std::string opening(const Run& run) {
  const Overall overall = overall_of(run);
  Document content{Paragraph{fmt::format("{} of {} subjects that count are sound; {}, seed {}, limit {}; Carom {}.",
                                         overall.sound, overall.subjects, extent_of(run), run.settings.seed,
                                         limit_in_words(run.settings.limits), version)}};
  if (run.baseline) {
    content.emplace_back(Paragraph{fmt::format("Against the baseline: {}.", baseline_verdict(*run.baseline))});
  }
  if (run.interrupted) {
    content.emplace_back(Paragraph{"The run was interrupted. These are the results so far.", "", true});
  }
  content = with(std::move(content), judge_error_part(run));
  content.emplace_back(subjects_table(run, Subjects::counting));
  content = with(std::move(content), beyond_domain_part(run, Subjects::counting));
  return in_markdown({Section{"Carom: " + in_words(overall), std::move(content)}}, level - 1);
}

std::string of_subject(const Run& run, const JudgedSubject& subject, const std::string& out_directory) {
  Document document;
  if (subject.status == SubjectStatus::violated && !subject.never_judged.empty()) {
    document.emplace_back(List{{name_cell(subject.result.subject.name)}});
    document.emplace_back(Paragraph{fmt::format("never judged: {}", listed(subject.never_judged))});
  }
  if (!subject.result.witnesses.empty()) {
    document.emplace_back(findings_part(run, subject, out_directory));
  }
  if (!subject.why_not_judged().empty()) {
    document.emplace_back(List{{name_cell(subject.result.subject.name)}});
    document.emplace_back(Paragraph{"could not be judged:"});
    document.emplace_back(Code{subject.why_not_judged()});
  }
  return document.empty() ? "" : '\n' + in_markdown(document, level);
}

}  // namespace

std::string run_markdown(const Run& run, const std::string& out_directory) {
  std::string text = opening(run);
  std::size_t left_out = 0;
  for (const JudgedSubject& subject : run.subjects) {
    const std::string section = subject.counts ? of_subject(run, subject, out_directory) : "";
    const bool fits = text.size() + section.size() <= longest_page;
    text += fits ? section : "";
    left_out += fits ? 0 : 1;
  }
  if (left_out > 0) {
    text += fmt::format("\nThe report holds the violations of {} more subjects.\n", left_out);
  }
  return text + '\n';
}

}  // namespace carom::report
