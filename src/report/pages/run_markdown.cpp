// SPDX-License-Identifier: BSL-1.0
#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/results/version.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

constexpr std::size_t longest_page = 1'000'000;
constexpr int level = 3;  // of a subject's heading

std::string opening(const Run& run) {
  const Overall overall = overall_of(run);
  Document content{Paragraph{fmt::format("{} of {} subjects that count are sound; {}, seed {}, limit {}; Carom {}.",
                                         overall.sound, overall.subjects, extent_of(run), run.options.seed,
                                         limit_in_words(run.options.limits), version)}};
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

std::string of_subject(const Run& run, std::size_t s, const std::string& out_directory) {
  const properties::SubjectResult& result = run.results[s];
  const std::string& why = why_not_judged(result);
  Document document;
  if (const auto never = never_judged(run, result); status_of(result) == SubjectStatus::violated && !never.empty()) {
    document.emplace_back(List{{name_cell(result.subject.name)}});
    document.emplace_back(Paragraph{fmt::format("never judged: {}", listed(never))});
  }
  if (!result.witnesses.empty()) {
    document.emplace_back(findings_part(run, s, out_directory));
  }
  if (!why.empty()) {
    document.emplace_back(List{{name_cell(result.subject.name)}});
    document.emplace_back(Paragraph{"could not be judged:"});
    document.emplace_back(Code{why});
  }
  return document.empty() ? "" : '\n' + in_markdown(document, level);
}

}  // namespace

std::string run_markdown(const Run& run, const std::string& out_directory) {
  std::string text = opening(run);
  std::size_t left_out = 0;
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    const std::string section = run.counts[s] ? of_subject(run, s, out_directory) : "";
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
