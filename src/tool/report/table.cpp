// SPDX-License-Identifier: BSL-1.0
#include "report/table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <carom/properties/trial/in_words.hpp>

#include "compare/comparison_text.hpp"
#include "report/adjusted.hpp"
#include "report/beyond_domain.hpp"
#include "report/extent.hpp"
#include "report/findings_text.hpp"
#include "report/html_report.hpp"
#include "report/not_claimed.hpp"
#include "version.hpp"

namespace carom::tool {
namespace {

using properties::GateReport;
using properties::SubjectResult;

std::string coverage_table(const GateReport& report) {
  std::string text = fmt::format("{:18} {:>8} {:>10} {:>8} {:>11} {:>6} {:>8} {:>9} {:>8} {:>8} {:>8} {:>8}\n",
                                 "family", "cases", "colliding", "resting", "separating", "inert", "invalid",
                                 "one wall", "spheres", "head-on", "ε = 0", "ε = 1");
  for (std::size_t f = 0; f < report.coverage.size(); ++f) {
    const properties::Coverage& c = report.coverage[f];
    text += fmt::format("{:18} {:8} {:10} {:8} {:11} {:6} {:8} {:9} {:8} {:8} {:8} {:8}\n",
                        report.options.families[f]->name, c.cases, c.colliding, c.resting, c.separating, c.inert,
                        c.invalid, c.one_immovable, c.spheres, c.head_on, c.inelastic, c.elastic);
  }
  return text;
}

std::string features_line(const properties::FeatureCoverage& features) {
  const auto missing = features.missing_pairs();
  const std::uint64_t feasible = features.feasible_pairs();
  std::string line =
      fmt::format("\n{} of {} pairs of features in colliding cases", feasible - missing.size(), feasible);
  constexpr std::size_t most_named = 5;
  for (std::size_t i = 0; i < std::min(missing.size(), most_named); ++i) {
    line += fmt::format("{} {} with {}", i == 0 ? "; missing" : ",", missing[i].x->name, missing[i].y->name);
  }
  return line + (missing.size() > most_named ? ", …\n" : "\n");
}

std::string digits_text(const SubjectResult& result) {
  const auto p50 = result.digits_at_least(0.5);
  if (!p50) {
    return "–";
  }
  return fmt::format("{:.1f} / {:.1f} / {:.1f}", *p50, *result.digits_at_least(0.99), *result.digits_at_least(1));
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

/// What the subject does not claim, and who said so.
std::string deviations_text(const Subject& subject, const std::vector<std::string>& of_command_line) {
  std::vector<std::string> own;
  std::vector<std::string> others;
  for (const std::string& deviation : subject.deviates) {
    const bool is_own = std::find(of_command_line.begin(), of_command_line.end(), deviation) == of_command_line.end();
    (is_own ? own : others).push_back(deviation);
  }
  const std::vector<std::string> of_matrix = not_claimed_without_matrix(subject);
  return (own.empty() ? "" : "    not claimed, by its own word: " + listed(own) + '\n') +
         (others.empty() ? "" : "    not claimed, by --deviates: " + listed(others) + '\n') +
         (of_matrix.empty() ? "" : fmt::format("    not claimed, {}: {}\n", shows_no_matrix, listed(of_matrix)));
}

std::string subject_line(const SubjectResult& result, const GateRun& run) {
  const GateReport& report = run.report;
  const auto worst = result.worst_backward_error(report.options);
  const std::size_t violated = result.violated_invariants().size();
  const std::string status = status_of(result);
  const std::string verdict = status == "violated" ? fmt::format("{} violated", violated) : status;
  const std::string error =
      determines_outcome(result.subject.model) ? fmt::format("{:.3g}", worst.backward_error) : std::string("–");
  std::string line =
      fmt::format("{:40} {:>8} {:>12} {:>10} {:18} {:>22} {:>8.0f}\n", result.subject.name, result.cases(), verdict,
                  error, worst.family, digits_text(result), result.nanoseconds_per_solve);
  if (result.skipped() > 0) {
    line += fmt::format("    {} cases skipped\n", result.skipped());
  }
  const properties::UnjudgedCounts unjudged = result.unjudged();
  for (const properties::Unjudged reason : properties::all_reasons_unjudged) {
    if (unjudged[reason] > 0) {
      line += fmt::format("    {} cases not judged: {}\n", unjudged[reason], in_words(reason));
    }
  }
  if (!result.error.empty()) {
    line += properties::indented("    error: " + result.error, "      ") + '\n';
  } else if (!result.not_judged.empty()) {
    line += "    not judged: " + result.not_judged + '\n';
  }
  if (report.options.budget && status == "sound") {
    line += "    " + cases_judged(result, report.options) + '\n';
  }
  return line + deviations_text(result.subject, run.deviates);
}

/// Of subjects that are kept because they fail, the first line alone.
std::string subject_table(const GateRun& run, bool counts) {
  std::string lines;
  for (std::size_t s = 0; s < run.report.results.size(); ++s) {
    if (run.counts[s] == counts) {
      const std::string of_subject = subject_line(run.report.results[s], run);
      lines += counts ? of_subject : of_subject.substr(0, of_subject.find('\n') + 1);
    }
  }
  return lines;
}

}  // namespace

std::string report_text(const GateRun& run, const std::string& out_directory) {
  const GateReport& report = run.report;
  const oracles::Yardstick& yardstick = report.options.yardstick;
  std::string text = fmt::format(
      "Carom {}: {}, seed {}, limit {}{}\n\n", version, extent_of(report.options), report.options.seed,
      yardstick.digits ? fmt::format("{} digits", *yardstick.digits) : fmt::format("{} ulps", yardstick.limit_ulps),
      yardstick.filtered ? "" : ", judged in exact arithmetic alone");
  if (report.interrupted) {
    text += "INTERRUPTED: what follows is what was judged until then\n\n";
  }
  text += coverage_table(report);
  text += features_line(report.features) + adjusted_sentences(report) + '\n';
  const std::string heading = fmt::format("\n{:40} {:>8} {:>12} {:>29} {:>22} {:>8}\n", "subject", "cases", "verdict",
                                          "worst backward error [ulps]", "digits p50/p99/worst", "ns/solve");
  text += heading + subject_table(run, true);
  const std::string expected = subject_table(run, false);
  if (!expected.empty()) {
    text += "\nkept because they fail, not counted\n" + expected;
  }
  for (const Subject& subject : run.absent) {
    text += fmt::format("{:40} absent: {}\n", subject.name, subject.absent);
  }
  text += beyond_domain_text(run);
  for (std::size_t s = 0; s < report.results.size(); ++s) {
    if (run.counts[s] && !report.results[s].witnesses.empty()) {
      text += '\n' + findings_text(run, s, out_directory);
    }
  }
  return text + (run.baseline ? compare::baseline_text(*run.baseline) : '\n' + summary_of(run) + '\n');
}

}  // namespace carom::tool
