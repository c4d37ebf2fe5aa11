// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/results/answer_json.hpp>
#include <carom/report/results/lists.hpp>
#include <carom/report/results/report_sum.hpp>
#include <carom/report/results/run_json.hpp>
#include <carom/report/results/version.hpp>
#include <carom/web/arbitrary.hpp>
#include <carom/web/commands.hpp>
#include <carom/web/replay.hpp>
#include <carom/web/request.hpp>

namespace carom::web {
namespace {

using nlohmann::json;

/// A report file as text. JavaScript's own writer would lose −0 and digits of large integers.
std::string in_json(const json& record) { return record.dump(2, ' ', false, json::error_handler_t::replace) + '\n'; }

std::uint64_t all_cases(const properties::GateOptions& options) {
  std::uint64_t all = 0;
  for (const properties::Family* family : options.families) {
    all += cases_of(options, *family);
  }
  return all;
}

/// The package installs its program for one project, so a user starts it by npx.
std::string with_npx(std::string text) {
  constexpr std::string_view command = "carom replay ";
  constexpr std::string_view starter = "npx ";
  for (std::size_t at = text.find(command); at != std::string::npos; at = text.find(command, at + command.size())) {
    text.insert(at, starter);
    at += starter.size();
  }
  return text;
}

report::Run run_of(const Request& request, properties::GateReport report) {
  return {std::move(report), request.environment, request.deviates, request.without_case, {true}, {}};
}

json list(const json& record) {
  const std::string what = record.at("what").get<std::string>();
  if (what == "families") {
    return report::families_list(record.contains("seed") ? count_from(record.at("seed"), "/seed") : 1);
  }
  if (what == "invariants") {
    return report::invariants_list();
  }
  if (what == "features") {
    return report::features_list();
  }
  if (what == "domains") {
    return report::domains_list();
  }
  throw FormatError("/what", "expected families, invariants, features or domains, found " + what);
}

json plan(const json& record) {
  const Request request = run_request_from(record);
  const auto names = [](const std::vector<const properties::Family*>& families) {
    return report::Json<std::vector<const properties::Family*>>::write(families);
  };
  return {{"cases", all_cases(request.options)},
          {"families", names(request.options.families)},
          {"without_case", names(request.without_case)}};
}

json part(const json& record) {
  Request request = run_request_from(record);
  request.options.shard = {count_from(record.at("part"), "/part"), count_from(record.at("of"), "/of")};
  request.options.shrinks = false;
  properties::GateReport report = properties::run_gate({request.subject}, request.options);
  report.results[0].witnesses.clear();  // the worst violations suffice to find them again
  report::Run run = run_of(request, std::move(report));
  run.is_shard = true;
  run.diagnoses.resize(1);
  return {{"report", report::report_record(run).dump(-1, ' ', false, json::error_handler_t::replace)}};
}

json files_of(const report::Run& run, const std::string& out) {
  json files = json::array();
  const auto add = [&](const std::string& file, std::string text) {
    files.push_back({{"file", file}, {"text", with_npx(std::move(text))}});
  };
  for (const properties::SubjectResult& result : run.results) {
    for (const properties::Witness& witness : result.witnesses) {
      add(report::witness_path("", result.subject, *witness.invariant),
          in_json(report::witness_record(witness, result.subject, run.options,
                                         report::witness_path(out, result.subject, *witness.invariant))));
    }
  }
  add("junit.xml", report::junit_xml(run));
  add("report.html", report::run_html(run, out));
  add("report.json", in_json(report::report_record(run)));
  return files;
}

/// The sum of the reports of parts. Without a part, it has no case.
properties::GateReport sum_of(const json& parts, const Request& request) {
  std::optional<properties::GateReport> sum;
  for (const json& one : parts) {
    properties::GateReport read = report::shard_from(parse_json(one.get_ref<const std::string&>()), "/reports").run;
    if (sum) {
      report::add_report(*sum, read);
    } else {
      sum = std::move(read);
    }
  }
  if (!sum) {
    std::stop_source stopped;
    stopped.request_stop();
    properties::GateOptions options = request.options;
    options.stop = stopped.get_token();
    sum = properties::run_gate({request.subject}, options);
  }
  return std::move(*sum);
}

json finish(const json& record) {
  const Request request = run_request_from(record);
  properties::GateReport sum = sum_of(record.at("reports"), request);
  report::complete_run(sum, request.options, {request.subject});
  sum.interrupted = record.value("interrupted", false);
  const report::Run run = report::diagnosed(run_of(request, std::move(sum)));
  return {{"status", run.exit_status()},
          {"text", with_npx(report::run_text(run, request.out))},
          {"markdown", with_npx(report::run_markdown(run, request.out))},
          {"files", files_of(run, request.out)}};
}

json draw(const json& record) {
  const properties::Family& family = properties::require_family("family", record.at("family").get<std::string>());
  const properties::Domain within = domain_of(record);
  const std::uint64_t seed = record.contains("seed") ? count_from(record.at("seed"), "/seed") : 1;
  const std::uint64_t first = record.contains("first") ? count_from(record.at("first"), "/first") : 0;
  json collisions = json::array();
  for (std::uint64_t i = 0; i < count_from(record.at("count"), "/count"); ++i) {
    collisions.push_back(collision_to_json(properties::drawn_case_within(within, family, seed, first + i).collision));
  }
  return {{"collisions", collisions}};
}

struct Command {
  std::string_view name;
  json (*answer)(const json& record);
};

constexpr std::array commands{
    Command{"version",
            [](const json&) -> json {
              return {{"version", report::version}};
            }},
    Command{"list", list},
    Command{"plan", plan},
    Command{"part", part},
    Command{"finish", finish},
    Command{"draw", draw},
    Command{"chosen", chosen},
    Command{"simpler", simpler},
    Command{"replay", replay},
    Command{"judge", judge},
};

}  // namespace

json answer_to(const json& request) {
  const std::string name = request.at("cmd").get<std::string>();
  const auto found =
      std::find_if(commands.begin(), commands.end(), [&](const Command& command) { return command.name == name; });
  if (found == commands.end()) {
    throw std::invalid_argument("there is no request " + name);
  }
  return found->answer(request);
}

}  // namespace carom::web
