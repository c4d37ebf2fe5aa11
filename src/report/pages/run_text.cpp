// SPDX-License-Identifier: BSL-1.0
#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/results/version.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {

std::string run_text(const Run& run, const std::string& out_directory) {
  Document document{Paragraph{fmt::format("Carom {}: {}, seed {}, limit {}{}", version, extent_of(run),
                                          run.options.seed, limit_in_words(run.options.limits),
                                          run.options.limits.filtered ? "" : ", judged only in exact arithmetic")}};
  if (run.interrupted) {
    document.emplace_back(Section{"", {Paragraph{"INTERRUPTED: these are the results so far"}}});
  }
  document = with(std::move(document), judge_error_part(run));
  document.emplace_back(Section{"", {coverage_table(run)}});
  document.emplace_back(Section{"", {Paragraph{features_in_words(run)}, Paragraph{adjusted_sentences(run)}}});
  document.emplace_back(Section{"", {subjects_table(run, Subjects::all)}});
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    if (run.counts[s] && !run.results[s].witnesses.empty()) {
      document.emplace_back(findings_part(run, s, out_directory));
    }
  }
  document = with(std::move(document), beyond_domain_part(run, Subjects::counting));
  document.emplace_back(
      Section{"", run.baseline ? with(comparison_part(*run.baseline, false),
                                      {Paragraph{fmt::format("Against the baseline {}: {}.", run.baseline->before.file,
                                                             baseline_verdict(*run.baseline))}})
                               : Document{Paragraph{summary_of(run)}}});
  return in_text(document);
}

}  // namespace carom::report
