// SPDX-License-Identifier: BSL-1.0
#include "report/html_report.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "commands/commands.hpp"
#include "compare/comparison_html.hpp"
#include "report/beyond_domain.hpp"
#include "report/extent.hpp"
#include "report/html_deviations.hpp"
#include "report/html_diagnosis.hpp"
#include "report/html_tables.hpp"
#include "report/html_witness.hpp"
#include "report/markup.hpp"
#include "report/page.hpp"
#include "version.hpp"

namespace carom::tool {
namespace {

std::string limit_of(const oracles::Yardstick& yardstick) {
  return yardstick.digits ? fmt::format("{} digits", *yardstick.digits) : fmt::format("{} ulps", yardstick.limit_ulps);
}

std::string meaning_of(const GateRun& run) {
  switch (run.exit_status()) {
    case exit_all_hold:
      return run.baseline ? "0: nothing is new" : "0: all hold";
    case exit_violated:
      return run.baseline ? "1: something is new" : "1: something is violated";
    default:
      return "2: not everything could be judged";
  }
}

void add_summary(pugi::xml_node section, const GateRun& run) {
  const properties::GateOptions& options = run.report.options;
  add(section, "p", {{"class", fmt::format("result exit-{}", run.exit_status())}}, summary_of(run));
  add_diagnoses(section, run);
  add_facts(section, {{"exit status", meaning_of(run)},
                      {"interrupted", run.report.interrupted ? "yes: what follows was judged until then" : "no"},
                      {"baseline", run.baseline ? compare::baseline_verdict(*run.baseline) : ""},
                      {"seed", std::to_string(options.seed)},
                      {"cases", extent_of(options)},
                      {"limit", limit_of(options.yardstick)},
                      {"relations", options.relations_every > 0
                                        ? fmt::format("each judged on every {}th case", options.relations_every)
                                        : "each judged on every case, of programs on every fourth"},
                      {"judge", options.yardstick.filtered ? "exact arithmetic, and bounds where they decide"
                                                           : "exact arithmetic alone (--exact)"}});
}

void add_environment(pugi::xml_node section, const GateRun& run) {
  const Environment& e = run.environment;
  std::vector<Fact> facts{{"Carom", version},
                          {"date", e.date},
                          {"seed", std::to_string(run.report.options.seed)},
                          {"compiler", e.compiler},
                          {"build type", e.build_type},
                          {"operating system", e.operating_system},
                          {"kernel", e.kernel},
                          {"processor", e.processor},
                          {"processor threads", std::to_string(e.processor_threads)}};
  for (const auto& [library, flags] : e.compiler_flags) {
    facts.emplace_back("flags of " + library, flags);
  }
  for (const properties::SubjectResult& result : run.report.results) {
    facts.emplace_back("version of " + result.subject.name, result.subject.version);
  }
  add_facts(section, facts);
}

struct Part {
  const char* anchor;
  const char* heading;
};
constexpr std::array<Part, 10> parts{{{"summary", "Summary"},
                                      {"baseline", "Against the baseline"},
                                      {"subjects", "Subjects"},
                                      {"invariants", "Invariants"},
                                      {"families", "Families"},
                                      {"violations", "What is violated where"},
                                      {"generated", "What was generated"},
                                      {"features", "Features"},
                                      {"witnesses", "Witnesses"},
                                      {"environment", "Environment"}}};

pugi::xml_node add_part(pugi::xml_node main, const char* anchor) {
  const auto part =
      std::find_if(parts.begin(), parts.end(), [&](const Part& one) { return std::string_view(one.anchor) == anchor; });
  const std::string heading = std::string(anchor) + "-heading";
  const pugi::xml_node section = add(main, "section", {{"id", anchor}, {"aria-labelledby", heading}});
  add(section, "h2", {{"id", heading}}, part->heading);
  return section;
}

void add_contents(pugi::xml_node body, const GateRun& run) {
  const pugi::xml_node list = add(add(body, "nav", {{"aria-label", "Contents"}}), "ul");
  for (const Part& part : parts) {
    if (part.anchor == std::string_view("baseline") && !run.baseline) {
      continue;
    }
    add(add(list, "li"), "a", {{"href", std::string("#") + part.anchor}}, part.heading);
  }
}

}  // namespace

std::string summary_of(const GateRun& run) {
  std::size_t counted = 0;
  std::size_t sound = 0;
  std::size_t violated = 0;
  for (std::size_t s = 0; s < run.counts.size(); ++s) {
    const std::string status = status_of(run.report.results[s]);
    counted += run.counts[s] ? 1 : 0;
    sound += run.counts[s] && status == "sound" ? 1 : 0;
    violated += run.counts[s] && status == "violated" ? 1 : 0;
  }
  const std::size_t others = counted - sound - violated;
  std::string text;
  if (counted == 0) {
    text = "No subject that counts was judged";
  } else if (sound == counted) {
    text = counted == 1 ? "The one subject that counts is sound"
                        : fmt::format("All {} subjects that count are sound", counted);
  } else if (counted == 1) {
    text = violated == 1 ? "The one subject that counts violates something"
                         : "The one subject that counts could not be judged to the end";
  } else {
    text = fmt::format("Of {} subjects that count, {} {} sound, {} {} an invariant", counted, sound,
                       sound == 1 ? "is" : "are", violated, violated == 1 ? "violates" : "violate");
    text += others == 0 ? "" : fmt::format(", and {} could not be judged to the end", others);
  }
  const std::size_t kept = run.counts.size() - counted;
  text += kept == 0 ? ""
                    : fmt::format("; {} more {} kept because {}", kept, kept == 1 ? "is" : "are",
                                  kept == 1 ? "it fails" : "they fail");
  text += run.absent.empty() ? "."
                             : fmt::format("; {} {} absent.", run.absent.size(), run.absent.size() == 1 ? "is" : "are");
  return run.report.interrupted ? "Interrupted. Until then: " + text : text;
}

std::string html_report(const GateRun& run, const std::filesystem::path& out_directory) {
  pugi::xml_document document;
  document.append_child(pugi::node_doctype).set_value("html");
  pugi::xml_node html = document.append_child("html");
  html.append_attribute("lang") = "en";
  add_head(html, "Carom: " + summary_of(run));
  const pugi::xml_node body = add(html, "body");
  add(body, "a", {{"class", "skip"}, {"href", "#main"}}, "Skip to the report");
  const pugi::xml_node header = add(body, "header");
  add(header, "h1", {}, "Carom: collision impulses against exact arithmetic");
  add_contents(header, run);
  const pugi::xml_node main = add(body, "main", {{"id", "main"}, {"tabindex", "-1"}});
  add_summary(add_part(main, "summary"), run);
  if (run.baseline) {
    compare::add_comparison(add_part(main, "baseline"), *run.baseline);
  }
  add_subjects(add_part(main, "subjects"), run);
  const pugi::xml_node invariants = add_part(main, "invariants");
  add_invariants(invariants, run);
  add_deviations(invariants, run);
  const pugi::xml_node families = add_part(main, "families");
  add_families(families, run);
  add_beyond_domain(families, run);
  add_violation_matrices(add_part(main, "violations"), run);
  add_coverage(add_part(main, "generated"), run);
  add_features(add_part(main, "features"), run);
  add_witnesses(add_part(main, "witnesses"), run, out_directory);
  add_environment(add_part(main, "environment"), run);
  add(add(body, "footer"), "p", {},
      "How to read this page: docs/guide/reading-a-report.md. The same as data: report.json and witnesses/ beside it.");
  return serialized(document) + '\n';
}

}  // namespace carom::tool
