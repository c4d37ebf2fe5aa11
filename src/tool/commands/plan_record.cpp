// SPDX-License-Identifier: BSL-1.0
#include <carom/collision/json/json.hpp>
#include <carom/report/results/run.hpp>
#include <carom/report/results/run_json.hpp>
#include <carom/report/results/version.hpp>

#include "commands/plan.hpp"
#include "io/this_environment.hpp"

namespace carom::tool::plan {
namespace {

using nlohmann::json;
using properties::plan::Candidate;
using properties::plan::Frame;
using properties::plan::JudgedCandidate;
using properties::plan::Part;
using properties::plan::Plan;

json optional_number(const std::optional<double>& number) { return number ? number_to_json(*number) : json(); }

json failure_record(const properties::plan::WorstFailure& failure, const Plan& plan) {
  return {{"place", plan.places[failure.contact]},
          {"why", failure.result.failure},
          {"backward_error_ulps", optional_number(failure.result.backward_error)},
          {"digits", optional_number(failure.result.digits)}};
}

json certificate_record(const properties::plan::Certificate& certificate, const Plan& plan) {
  json record{{"contacts", certificate.contacts},
              {"failures", certificate.failures},
              {"worst_backward_error_ulps", optional_number(certificate.worst_backward_error)},
              {"least_digits", optional_number(certificate.least_digits)}};
  if (certificate.worst) {
    record["worst_failure"] = failure_record(*certificate.worst, plan);
  }
  return record;
}

json candidate_record(const JudgedCandidate& one, const Part& part, const Plan& plan) {
  const Candidate& candidate = plan.candidates[one.candidate];
  return {{"subject", candidate.subject.name},
          {"law", name_of(candidate.subject.law)},
          {"precision", candidate.scalar},
          {"solve", candidate.solve},
          {"frame", candidate.frame == Frame::world ? "world" : "body"},
          {"batch", candidate.is_batch},
          {"serves", one.serves},
          {"certificate", certificate_record(one.certificate, plan)},
          {"nanoseconds", optional_number(one.nanoseconds)},
          {"saving", one.nanoseconds ? number_to_json(part.saving_of(one)) : json()}};
}

json choice_record(const std::optional<std::size_t>& choice, const Part& part, const Plan& plan) {
  if (!choice) {
    return {};
  }
  const JudgedCandidate& one = part.candidates[*choice];
  json record = candidate_record(one, part, plan);
  record["header"] = header_of(plan.candidates[one.candidate].subject.name);
  return record;
}

json laws_record(const Part& part) {
  json laws = json::array();
  for (const properties::plan::LawCount& count : part.laws) {
    json reasons = json::object();
    for (const auto reason : properties::plan::all_reductions) {
      if (count.by_reason[reason] > 0) {
        reasons[std::string(in_words(reason))] = count.by_reason[reason];
      }
    }
    laws.push_back(
        {{"law", name_of(count.law)}, {"exactly", count.exactly()}, {"served", count.served}, {"reasons", reasons}});
  }
  return laws;
}

json forms_record(const Part& part) {
  json forms = json::object();
  for (const auto form : properties::plan::all_torque_forms) {
    forms[std::string(name_of(form))] = part.torque_forms[form];
  }
  return forms;
}

json part_record(const Part& part, const Plan& plan) {
  json candidates = json::array();
  for (const JudgedCandidate& one : part.candidates) {
    candidates.push_back(candidate_record(one, part, plan));
  }
  return {{"name", part.name},
          {"contacts", part.contacts.size()},
          {"colliding", part.colliding},
          {"torque_forms", forms_record(part)},
          {"timed_contacts", part.timed_contacts},
          {"baseline_nanoseconds", optional_number(part.baseline_nanoseconds)},
          {"laws", laws_record(part)},
          {"one_at_a_time", choice_record(part.one_at_a_time, part, plan)},
          {"in_batches", choice_record(part.in_batches, part, plan)},
          {"candidates", candidates}};
}

}  // namespace

int PlanRun::exit_status() const { return plan.serves() ? report::exit_all_hold : report::exit_violated; }

json plan_record(const PlanRun& run) {
  const Plan& plan = run.plan;
  json demand{{"law", name_of(run.demand.law)}, {"exact_law", run.demand.exact_law}};
  if (run.demand.digits) {
    demand["digits"] = *run.demand.digits;
  } else {
    demand["limit_ulps"] = run.demand.limit_ulps;
  }
  json record{{"carom", report::version},
              {"environment", report::environment_record(this_environment())},
              {"file", run.file},
              {"demand", demand},
              {"repetitions", run.repetitions},
              {"exit_status", run.exit_status()},
              {"left_out", plan.left_out},
              {"classes", json::array()},
              {"whole", plan.classes.empty() ? json() : part_record(plan.whole, plan)},
              {"saving_by_class",
               {{"one_at_a_time", optional_number(plan.saving_by_class(false))},
                {"in_batches", optional_number(plan.saving_by_class(true))}}},
              {"findings", json::array()}};
  for (const Part& part : plan.classes) {
    record["classes"].push_back(part_record(part, plan));
  }
  for (const properties::plan::LintFinding& finding : plan.findings) {
    record["findings"].push_back({{"lint", name_of(finding.lint)},
                                  {"severity", name_of(finding.severity)},
                                  {"place", finding.place},
                                  {"field", finding.field},
                                  {"text", finding.text}});
  }
  return record;
}

}  // namespace carom::tool::plan
