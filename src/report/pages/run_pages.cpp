// SPDX-License-Identifier: BSL-1.0
#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/results/run.hpp>
#include <carom/report/results/version.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

std::string meaning_of(const Run& run) {
  switch (run.exit_status()) {
    case exit_all_hold:
      return run.baseline ? "0: there are no new violations" : "0: all invariants hold";
    case exit_violated:
      return run.baseline ? "1: there are new violations" : "1: a subject violates an invariant";
    default:
      return run.judge_error ? "2: the judge failed" : "2: some subjects could not be judged";
  }
}

Document verdict_part(const Run& run) {
  return with({Paragraph{summary_of(run), fmt::format("result exit-{}", run.exit_status())},
               Facts{{{"exit status", meaning_of(run)},
                      {"interrupted", run.interrupted ? "yes: this page shows the results so far" : "no"},
                      {"baseline", run.baseline ? baseline_verdict(*run.baseline) : ""},
                      {"cases", extent_of(run)},
                      {"left out", without_case_in_words(run)}}}},
              judge_error_part(run));
}

Document features_part(const Run& run) {
  return {Paragraph{features_in_words(run) + '.'},
          Details{"Number of colliding cases with each feature", {features_table(run)}}};
}

Document environment_part(const Run& run) {
  const Environment& e = run.environment;
  const properties::GateOptions& options = run.options;
  Facts facts{{{"Carom", run.carom},
               {"date", e.date},
               {"seed", std::to_string(options.seed)},
               {"limit", limit_in_words(options.limits)},
               {"relations", options.relations_every > 0
                                 ? fmt::format("each is judged on every {}th case", options.relations_every)
                                 : "each is judged on every case; under coulomb on every second one, for programs on "
                                   "every fourth one"},
               {"judge", options.limits.filtered ? "exact arithmetic, and faster bounds if they decide the verdict"
                                                 : "only exact arithmetic (--exact)"},
               {"compiler", e.compiler},
               {"build type", e.build_type},
               {"operating system", e.operating_system},
               {"kernel", e.kernel},
               {"processor", e.processor},
               {"processor threads", std::to_string(e.processor_threads)}}};
  for (const auto& [library, flags] : e.compiler_flags) {
    facts.pairs.emplace_back("flags of " + library, flags);
  }
  for (const properties::SubjectResult& result : run.results) {
    facts.pairs.emplace_back("version of " + result.subject.name, result.subject.version);
  }
  return {std::move(facts)};
}

}  // namespace

std::string run_text(const Run& run, const std::string& out_directory, bool has_coverage) {
  Document document{Paragraph{fmt::format("Carom {}: {}, seed {}, limit {}{}", version, extent_of(run),
                                          run.options.seed, limit_in_words(run.options.limits),
                                          run.options.limits.filtered ? "" : ", judged only in exact arithmetic")}};
  if (const std::string without_case = without_case_in_words(run); !without_case.empty()) {
    document.emplace_back(Paragraph{without_case});
  }
  if (run.interrupted) {
    document.emplace_back(Section{"", {Paragraph{"INTERRUPTED: these are the results so far"}}});
  }
  document = with(std::move(document), judge_error_part(run));
  document.emplace_back(Section{"", {subjects_table(run, Subjects::all)}});
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    if (run.counts[s] && !run.results[s].witnesses.empty()) {
      document.emplace_back(finding_part(run, s, out_directory, Form::terminal));
    }
  }
  if (has_coverage) {
    document.emplace_back(Section{"Generated cases", {coverage_table(run)}});
    document.emplace_back(Section{"", {Paragraph{features_in_words(run)}, Paragraph{adjusted_sentences(run)}}});
    document = with(std::move(document), violated_families_part(run));
    document = with(std::move(document), beyond_domain_part(run, Subjects::counting));
  }
  document.emplace_back(
      Section{"", run.baseline ? with(comparison_part(*run.baseline, false),
                                      {Paragraph{fmt::format("Against the baseline {}: {}.", run.baseline->before.file,
                                                             baseline_verdict(*run.baseline))}})
                               : Document{Paragraph{summary_of(run)}}});
  return in_text(document);
}

std::string run_html(const Run& run, const std::string& out_directory) {
  Page page{"Carom: " + summary_of(run),
            "Carom: collision impulses against exact arithmetic",
            {},
            {},
            "docs/guide/reading-a-report.md explains this page. The files report.json and witnesses/ in the same "
            "directory hold the same data."};
  const auto add_part = [&](const char* anchor, const char* heading, Document content) {
    if (!content.empty()) {
      page.contents.emplace_back(anchor, heading);
      page.main.emplace_back(Section{heading, std::move(content), anchor});
    }
  };
  add_part("summary", "Verdict", verdict_part(run));
  add_part("subjects", "Subjects", with({subjects_table(run, Subjects::all)}, errors_part(run)));
  add_part("faults", "Faults", findings_part(run, out_directory));
  if (run.baseline) {
    add_part("baseline", "Against the baseline",
             with({Paragraph{summary_of(*run.baseline), "result"}}, comparison_part(*run.baseline, true)));
  }
  add_part("invariants", "Invariants", with(with(invariants_part(run), never_judged_part(run)), deviations_part(run)));
  add_part("energy", "Energy", energy_part(run));
  add_part("witnesses", "Witnesses", witnesses_part(run, out_directory));
  add_part("families", "Families", with(families_part(run), beyond_domain_part(run, Subjects::all)));
  add_part("violations", "Violations by family and feature", violations_part(run));
  add_part("generated", "Generated cases", {coverage_table(run), Paragraph{adjusted_sentences(run)}});
  add_part("features", "Features", features_part(run));
  add_part("environment", "Environment", environment_part(run));
  return html_page(page);
}

}  // namespace carom::report
