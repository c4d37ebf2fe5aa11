// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/domain_proposals.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/gate/suggested_effects.hpp>
#include <carom/properties/gate/ways_on.hpp>

namespace carom::properties {
namespace {

/// Judges a subject on fresh cases, until it has judged as many as the run did.
class FreshRuns {
 public:
  FreshRuns(const SubjectResult& result, const GateReport& report) : result_(&result), report_(&report) {}

  [[nodiscard]] bool are_over() const {
    constexpr unsigned most_runs = 30;
    return judged_ >= result_->cases() || runs_ == most_runs || report_->options.stop.stop_requested();
  }

  /// The result of a subject in a domain, to its first violation. None if no case lies within the domain.
  [[nodiscard]] std::optional<SubjectResult> run(const Subject& subject, const Domain& within) {
    constexpr std::uint64_t most_cases = 200;  // of each family
    const GateOptions& of_run = report_->options;
    GateOptions options;
    options.seed = of_run.seed + 1;
    options.within = within;
    options.limits = of_run.limits;
    options.workers = of_run.workers;
    options.relations_every = of_run.relations_every;
    options.fail_fast = true;
    options.shrinks = false;
    options.stop = of_run.stop;
    std::uint64_t weights = 0;
    for (const Family* family : of_run.families) {
      weights += static_cast<std::uint64_t>(family->weight);
      if (has_cases_within(within, *family, options.seed)) {
        options.families.push_back(family);
      }
    }
    options.cases = std::clamp<std::uint64_t>(result_->cases() / weights / 2, 1, most_cases);
    if (options.families.empty()) {
      return std::nullopt;
    }
    GateReport report = run_gate({subject}, options);
    if (report.judge_error) {
      throw *report.judge_error;
    }
    judged_ += report.results[0].cases();
    ++runs_;
    return std::move(report.results[0]);
  }

 private:
  const SubjectResult* result_;
  const GateReport* report_;
  std::uint64_t judged_ = 0;
  unsigned runs_ = 0;
};

/// A subject whose effects decide too many cases is not judged in the domain of the run, but the rest is right.
bool has_no_fault(const SubjectResult& result) {
  const EffectCounts decided = result.decided_by();
  const bool are_decided = std::ranges::any_of(decided, [](std::uint64_t count) { return count > 0; });
  return result.is_sound() || (result.error.empty() && result.violated_invariants().empty() && are_decided);
}

std::optional<WayOn> way_by_effects(const SubjectResult& result, const GateReport& report, FreshRuns& runs) {
  const DeclaredEffects suggested = suggested_effects(result, report);
  std::vector<DeclaredEffects> tried{suggested};
  for (const DeclaredEffect effect : all_declared_effects) {
    DeclaredEffects alone;
    alone[effect] = suggested[effect];
    if (suggested[effect] > 0 && alone != suggested) {
      tried.push_back(alone);
    }
  }
  if (suggested == DeclaredEffects{}) {
    return std::nullopt;
  }
  for (const DeclaredEffects& effects : tried) {
    Subject subject = result.subject;
    for (const DeclaredEffect effect : all_declared_effects) {
      subject.effects[effect] += effects[effect];
    }
    const std::optional<SubjectResult> found =
        runs.are_over() ? std::nullopt : runs.run(subject, report.options.within);
    if (found && has_no_fault(*found)) {
      return WayOn{std::nullopt, subject.effects, found->cases()};
    }
  }
  return std::nullopt;
}

std::optional<WayOn> way_by_domain(const SubjectResult& result, const GateReport& report, FreshRuns& runs) {
  DomainProposals proposals(result, report);
  while (!runs.are_over()) {
    const std::optional<Domain> domain = proposals.next();
    const std::optional<SubjectResult> found = domain ? runs.run(result.subject, *domain) : std::nullopt;
    if (found && found->is_sound()) {
      return WayOn{domain, {}, found->cases()};
    }
    if (!domain || (found && !found->error.empty())) {
      return std::nullopt;
    }
    for (std::size_t f = 0; found && f < found->families.size(); ++f) {
      for (const auto& [invariant, worst] : found->families[f].worst) {
        proposals.add_violation(worst.original.collision);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

void add_ways_on(GateReport& report, const std::vector<bool>& counts) {
  CAROM_EXPECTS(counts.size() == report.results.size(), counts.size(), report.results.size());
  const GateOptions& options = report.options;
  if (options.fail_fast || options.shard.of > 1 || report.interrupted || report.judge_error) {
    return;
  }
  for (std::size_t s = 0; s < report.results.size(); ++s) {
    SubjectResult& result = report.results[s];
    if (!counts[s] || !result.error.empty() || result.violated_invariants().empty()) {
      continue;
    }
    std::vector<WayOn> ways;
    const std::string fault = why_failed([&] {
      FreshRuns runs(result, report);
      for (const auto& seek : {way_by_effects, way_by_domain}) {
        if (std::optional<WayOn> way = seek(result, report, runs)) {
          ways.push_back(*std::move(way));
        }
      }
    });
    if (fault.empty() && !options.stop.stop_requested()) {
      result.ways_on = std::move(ways);
    }
  }
}

}  // namespace carom::properties
