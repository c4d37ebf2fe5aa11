// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/report/pages/document.hpp>
#include <carom/report/pictures/measurement.hpp>
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

using report::Document;
using report::Table;

using properties::plan::all_lints;
using properties::plan::LawCount;
using properties::plan::LintFinding;

/// At most this many findings of one kind are shown. The others are only counted.
constexpr std::size_t findings_shown = 5;

std::string number_or_dash(const std::optional<double>& number, const char* format) {
  return number ? fmt::format(fmt::runtime(format), *number) : "–";
}

/// How torques are computed for the part's contacts, such as "equal/plain".
std::string forms_of(const Part& part) {
  std::string names;
  for (const auto form : properties::plan::all_torque_forms) {
    if (part.torque_forms[form] > 0) {
      names += fmt::format("{}{}", names.empty() ? "" : "/", name_of(form));
    }
  }
  return names;
}

std::string in_words(const Candidate& candidate, const Part& part) {
  return fmt::format("{}, {}, {}", candidate.scalar, candidate.solve,
                     candidate.frame == Frame::world ? "world frame" : fmt::format("body frame ({})", forms_of(part)));
}

/// Every class, followed by the part with all contacts.
std::vector<const Part*> parts_of(const Plan& plan) {
  std::vector<const Part*> parts;
  for (const Part& part : plan.classes) {
    parts.push_back(&part);
  }
  if (!plan.classes.empty()) {
    parts.push_back(&plan.whole);
  }
  return parts;
}

void add_choice(Table& table, const Part& part, const Plan& plan, bool in_batches) {
  const std::optional<std::size_t>& choice = in_batches ? part.in_batches : part.one_at_a_time;
  std::vector<std::string> row{part.name, fmt::format("{}", part.contacts.size()),
                               in_batches ? "in batches" : "one at a time"};
  if (!choice) {
    row.insert(row.end(), {"nothing serves", "", "", "", "", "", ""});
  } else {
    const JudgedCandidate& one = part.candidates[*choice];
    const Candidate& candidate = plan.candidates[one.candidate];
    row.push_back(candidate.subject.name);
    row.push_back(header_of(candidate.subject.name));
    row.push_back(in_words(candidate, part));
    row.push_back(number_or_dash(one.certificate.worst_backward_error, "{:.3g}"));
    row.push_back(number_or_dash(one.certificate.least_digits, "{:.1f}"));
    row.push_back(one.nanoseconds ? report::in_three_digits(*one.nanoseconds) : "–");
    row.push_back(one.nanoseconds ? fmt::format("{:.2g}", part.saving_of(one)) : "–");
  }
  table.rows.push_back({{row.begin(), row.end()}});
}

Table choices(const Plan& plan) {
  Table table{"",
              {{"class"},
               {"contacts"},
               {"solved"},
               {"least that serves"},
               {"header"},
               {"computes in"},
               {"worst ulps"},
               {"least digits"},
               {"ns a contact"},
               {"times as quick"}},
              {}};
  for (const Part* part : parts_of(plan)) {
    add_choice(table, *part, plan, false);
    add_choice(table, *part, plan, true);
  }
  return table;
}

/// For each lesser (cheaper) law, the number of contacts on which it equals the requested law.
Table laws(const Plan& plan, Law law) {
  Table table{
      "", {{"class"}, {"law"}, {"serves on"}, {fmt::format("is {} exactly on", name_of(law))}, {"because"}}, {}};
  for (const Part* part : parts_of(plan)) {
    for (const LawCount& count : part->laws) {
      if (count.law == law) {
        continue;
      }
      std::string reasons;
      for (const auto reason : properties::plan::all_reductions) {
        if (count.by_reason[reason] > 0) {
          reasons += fmt::format("{}{} ({})", reasons.empty() ? "" : "; ", properties::plan::in_words(reason),
                                 count.by_reason[reason]);
        }
      }
      table.rows.push_back(
          {{part->name, std::string(name_of(count.law)), fmt::format("{} of {}", count.served, part->contacts.size()),
            fmt::format("{} of {}", count.exactly(), part->contacts.size()), reasons.empty() ? "–" : reasons}});
    }
  }
  return table;
}

/// The candidates that do not serve all contacts. If no candidate of a law serves all, the law has one row, for its
/// best candidate.
Table failures(const Plan& plan) {
  Table table{
      "", {{"does not serve"}, {"contacts failed"}, {"worst at"}, {"because"}, {"ulps there"}, {"digits there"}}, {}};
  const auto add = [&](const std::string& name, const JudgedCandidate& one) {
    if (!one.certificate.worst) {
      table.rows.push_back({{name, "0", "–", "it is another law", "–", "–"}});
      return;
    }
    const auto& [contact, result] = *one.certificate.worst;
    table.rows.push_back(
        {{name, fmt::format("{} of {}", one.certificate.failures, one.certificate.contacts), plan.places[contact],
          result.failure, number_or_dash(result.backward_error, "{:.3g}"), number_or_dash(result.digits, "{:.1f}")}});
  };
  for (const LawCount& count : plan.whole.laws) {
    std::vector<const JudgedCandidate*> of_law;
    for (const JudgedCandidate& one : plan.whole.candidates) {
      if (plan.candidates[one.candidate].subject.law == count.law) {
        of_law.push_back(&one);
      }
    }
    if (std::ranges::none_of(of_law, &JudgedCandidate::serves)) {
      add(fmt::format("{}, however computed", name_of(count.law)),
          **std::ranges::min_element(of_law, {}, [](const auto* one) { return one->certificate.failures; }));
      continue;
    }
    for (const JudgedCandidate* one : of_law) {
      if (!one->serves) {
        add(plan.candidates[one->candidate].subject.name, *one);
      }
    }
  }
  return table;
}

Table findings(const Plan& plan) {
  Table table{"", {{"severity"}, {"lint"}, {"place"}, {"field"}, {"what"}}, {}};
  for (const auto lint : all_lints) {
    std::size_t count = 0;
    for (const LintFinding& finding : plan.findings) {
      if (finding.lint == lint && ++count <= findings_shown) {
        table.rows.push_back({{std::string(name_of(finding.severity)), std::string(name_of(lint)), finding.place,
                               finding.field, finding.text}});
      }
    }
    if (count > findings_shown) {
      table.rows.push_back(
          {{"", std::string(name_of(lint)), "", "", fmt::format("and {} more", count - findings_shown)}});
    }
  }
  return table;
}

std::string accuracy_in_words(const properties::plan::Demand& demand) {
  return demand.digits ? fmt::format("{} correct digits", *demand.digits)
                       : fmt::format("{:g} ulps of binary64", demand.limit_ulps);
}

std::string saving_in_words(const Plan& plan) {
  const auto one = plan.saving_by_class(false);
  const auto batch = plan.saving_by_class(true);
  return fmt::format(
      "If each class uses its own choice, all contacts together take {} times less time one at a time, and {} times "
      "less in batches.",
      number_or_dash(one, "{:.2g}"), number_or_dash(batch, "{:.2g}"));
}

Document page(const PlanRun& run) {
  const Plan& plan = run.plan;
  Document document{report::Paragraph{fmt::format("{}: {} contacts, {} of them colliding; asked for: {}, {}", run.file,
                                                  plan.whole.contacts.size(), plan.whole.colliding,
                                                  name_of(run.demand.law), accuracy_in_words(run.demand))}};
  if (plan.left_out > 0) {
    document.emplace_back(report::Paragraph{
        fmt::format("ignored contacts, because no law is defined for their coefficients: {}", plan.left_out)});
  }
  const auto add = [&](const char* title, Table table) {
    if (!table.rows.empty()) {
      document.emplace_back(report::Section{title, {std::move(table)}});
    }
  };
  add("", choices(plan));
  if (run.repetitions > 0 && !plan.classes.empty()) {
    document.emplace_back(report::Section{
        "",
        {report::Paragraph{fmt::format("The speedups are relative to {}-double. The times are medians of the same run, "
                                       "over at most {} contacts of each class and {} repetitions in random order. {}",
                                       name_of(run.demand.law), properties::plan::contacts_timed, run.repetitions,
                                       saving_in_words(plan))}}});
  }
  add("Lesser laws", laws(plan, run.demand.law));
  add("Methods that do not serve the whole", failures(plan));
  add("Findings of the lint", findings(plan));
  return document;
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

std::string plan_text(const PlanRun& run) { return in_text(page(run)); }

}  // namespace carom::tool::plan
