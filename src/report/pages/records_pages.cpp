// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pugixml.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/document.hpp>
#include <carom/report/pages/records_pages.hpp>
#include <carom/report/pictures/markup.hpp>
#include <carom/report/results/run.hpp>
#include <carom/report/results/version.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using nlohmann::json;
using properties::records::Broken;
using properties::records::PlacedRecord;
using properties::records::RecordsReport;
using properties::records::Spread;

constexpr std::size_t most_broken = 3;  // shown of one record

std::string law_in_words(const RecordsReport& report) {
  return report.has_law ? fmt::format("under the law {}", name_of(report.law))
                        : "under what holds for every law (--law names one)";
}

/// What −N would change, if most records are violated and separate. Empty otherwise.
std::string reversed_in_words(const RecordsReport& report) {
  if (2 * report.violated_apart <= report.records) {
    return {};
  }
  const bool hold = report.hold_reversed > report.held();
  return fmt::format("; N points from B to A in Carom; with −N, {} of {} records {}",
                     hold ? report.hold_reversed : report.violated_apart, report.records, hold ? "hold" : "approach");
}

/// The places of the violated records in the file, cut to one line.
std::string places_in_words(const RecordsReport& report) {
  constexpr std::size_t most_shown = 40;
  const auto& at = report.violated_at;
  const std::span<const std::uint64_t> first(at.data(), std::min(at.size(), most_shown));
  std::string text = fmt::format("{}", fmt::join(first, ", "));
  if (report.violated > first.size()) {
    text += fmt::format(", … ({} in all; --format json has {})", report.violated,
                        report.violated > at.size() ? fmt::format("the first {}", at.size()) : "them");
  }
  return text;
}

bool leaves_out_many(const RecordsReport& report) { return 10 * report.not_judged > report.records; }

std::string verdict_of(const RecordsReport& report) {
  if (report.held() + report.violated == 0) {
    return "NOT JUDGED: no record was judged";
  }
  const std::string held = fmt::format("{} of {} records hold {}", report.held(), report.records, law_in_words(report));
  if (report.violated == 0 && leaves_out_many(report)) {
    return fmt::format("NOT JUDGED: {} of {} records, which is more than a tenth; {}", report.not_judged,
                       report.records, held);
  }
  return (report.violated > 0 ? "VIOLATED: " : "") + held + reversed_in_words(report);
}

/// The names of fields that a record may misspell.
std::string unknown_in_words(const RecordsReport& report) {
  std::vector<std::string> names;
  for (const std::string& path : report.unknown) {
    const std::string name = path.substr(path.rfind('.') + 1);
    const std::vector<std::string>& known = fields_of_records();
    const bool is_misspelt = path != "class" && std::find(known.begin(), known.end(), name) == known.end();
    names.push_back(shown(path) + (is_misspelt ? properties::did_you_mean(name, known) : ""));
  }
  return names.empty() ? "" : fmt::format("{}", fmt::join(names, ", "));
}

Document head_of(const RecordsReport& report) {
  std::string rest;
  if (report.not_judged > 0) {
    rest = fmt::format(
        "{} records: {}numbers leave their range", report.not_judged,
        report.law == Law::rough ? "the record lacks restitution, friction or tangential_restitution, or " : "");
  }
  Document head{Paragraph{fmt::format("Carom {}: {}", version, shown(report.file))},
                Paragraph{verdict_of(report), fmt::format("result exit-{}", exit_status_of(report))},
                Facts{{{"digits", report.resolution.in_words()},
                       {"violated records", places_in_words(report)},
                       {"not judged", rest},
                       {"fields that no law reads", unknown_in_words(report)},
                       {"not read to the end", shown(report.error)},
                       {"interrupted", report.interrupted ? "yes: these are the results so far" : ""}}}};
  return head;
}

Table laws_table(const RecordsReport& report) {
  Table table{"The laws that the records satisfy", {{"law"}, {"records that satisfy it", true}, {"judged", true}}, {}};
  for (const Law law : all_laws) {
    if (report.judged[law] > 0) {
      table.rows.push_back(
          {{std::string(name_of(law)), std::to_string(report.satisfied[law]), std::to_string(report.judged[law])}});
    }
  }
  return table;
}

std::string shortly(double number) { return fmt::format("{:.4g}", number); }

Table implied_table(const RecordsReport& report) {
  Table table{"The coefficients that the records imply",
              {{"implied"}, {"median", true}, {"least", true}, {"greatest", true}, {"records", true}},
              {}};
  const auto add_row = [&](const char* name, const Spread& spread) {
    if (spread.count > 0) {
      table.rows.push_back({{name, shortly(spread.median), shortly(spread.least), shortly(spread.greatest),
                             std::to_string(spread.count)}});
    }
  };
  add_row("restitution ε", report.restitution);
  add_row("friction μ (records that slip)", report.friction);
  add_row("tangential restitution e_t", report.tangential_restitution);
  return table;
}

ReportedOutcome answer_of(const PlacedRecord& one) { return reported(one.record.after); }

Document worst_part(const RecordsReport& report) {
  Document part;
  for (const PlacedRecord& one : report.worst) {
    std::string text;
    for (std::size_t i = 0; i < std::min(one.broken.size(), most_broken); ++i) {
      text += one.broken[i].words + '\n';
    }
    if (one.broken.size() > most_broken) {
      text += fmt::format("and {} more\n", one.broken.size() - most_broken);
    }
    text += properties::in_words(one.record.collision, "  ") + "  after\n" + properties::in_words(answer_of(one), "  ");
    for (const auto& [name, value] : one.record.others.items()) {
      text += fmt::format("  {}: {}\n", shown(name), shown(value.dump(-1, ' ', false, json::error_handler_t::replace)));
    }
    part.emplace_back(Paragraph{shown(one.place)});
    part.emplace_back(Code{text});
  }
  return part;
}

Document faults_part(const RecordsReport& report) {
  List list;
  for (const properties::diagnosis::Fault& fault : report.faults) {
    list.items.emplace_back(fmt::format("{}", fmt::join(properties::diagnosis::lines_of(fault), " ")));
  }
  return list.items.empty() ? Document() : Document{list};
}

/// The sections after the head, each with its title.
std::vector<std::pair<std::string, Document>> sections_of(const RecordsReport& report) {
  std::vector<std::pair<std::string, Document>> sections;
  const auto add_section = [&](std::string title, Document content) {
    if (!content.empty()) {
      sections.emplace_back(std::move(title), std::move(content));
    }
  };
  if (report.records == 0) {
    return sections;
  }
  add_section(report.diagnosed_as == Law::any
                  ? "What is wrong"
                  : fmt::format("What is wrong, compared with the law {}", name_of(report.diagnosed_as)),
              faults_part(report));
  if (!report.has_law) {
    add_section("The laws that the records satisfy", {laws_table(report)});
  }
  if (Table implied = implied_table(report); !implied.rows.empty()) {
    add_section("The coefficients that the records imply", {std::move(implied)});
  }
  add_section(report.violated > report.worst.size()
                  ? fmt::format("The worst {} of {} violated records", report.worst.size(), report.violated)
                  : "The violated records, the worst first",
              worst_part(report));
  return sections;
}

json spread_record(const Spread& spread) {
  if (spread.count == 0) {
    return {{"records", 0}};
  }
  return {{"records", spread.count},
          {"median", number_to_json(spread.median)},
          {"least", number_to_json(spread.least)},
          {"greatest", number_to_json(spread.greatest)}};
}

json placed_record(const PlacedRecord& one) {
  json broken = json::array();
  for (const Broken& each : one.broken) {
    broken.push_back(
        {{"invariant", each.invariant->name}, {"ratio", number_to_json(each.ratio)}, {"words", each.words}});
  }
  const auto velocities = [](const BodyVelocity<double>& motion) {
    return json{{"velocity", vector_to_json(motion.velocity)},
                {"angular_velocity", vector_to_json(motion.angular_velocity)}};
  };
  json record = collision_to_json(one.record.collision);
  record["after"] = {{"a", velocities(one.record.after.a)}, {"b", velocities(one.record.after.b)}};
  return {{"place", one.place}, {"violates", broken}, {"record", record}, {"others", one.record.others}};
}

/// The invariants that a record is judged by under the law.
std::vector<const properties::Invariant*> judged_invariants(const RecordsReport& report) {
  std::vector<const properties::Invariant*> judged;
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    const bool is_violated = report.violations.contains(&invariant);
    const bool is_of_outcome = std::holds_alternative<properties::AboutOutcome>(invariant.about);
    if (is_violated || (is_of_outcome && invariant.claimed_for(report.law))) {
      judged.push_back(&invariant);
    }
  }
  return judged;
}

}  // namespace

int exit_status_of(const RecordsReport& report) {
  if (!report.error.empty() || report.interrupted || report.records == 0) {
    return exit_usage;
  }
  if (report.violated > 0) {
    return exit_violated;
  }
  return leaves_out_many(report) ? exit_usage : exit_all_hold;
}

std::string records_text(const RecordsReport& report) {
  Document document = head_of(report);
  for (const auto& [title, content] : sections_of(report)) {
    document.emplace_back(Section{title, content});
  }
  return in_text(document);
}

std::string records_html(const RecordsReport& report) {
  Page page{fmt::format("Carom: {}", shown(report.file)), "Recorded collisions", {}, head_of(report)};
  for (const auto& [title, content] : sections_of(report)) {
    page.main.emplace_back(Section{title, content});
  }
  return html_page(page);
}

json records_record(const RecordsReport& report) {
  json laws = json::object();
  for (const Law law : all_laws) {
    if (report.judged[law] > 0) {
      laws[std::string(name_of(law))] = {{"judged", report.judged[law]}, {"satisfied", report.satisfied[law]}};
    }
  }
  json violations = json::object();
  for (const auto& [invariant, count] : report.violations) {
    violations[std::string(invariant->name)] = count;
  }
  json worst = json::array();
  for (const PlacedRecord& one : report.worst) {
    worst.push_back(placed_record(one));
  }
  json faults = json::array();
  for (const properties::diagnosis::Fault& fault : report.faults) {
    faults.push_back({{"what", fault.what}, {"where", fault.where}, {"look_at", fault.look_at}});
  }
  json record{{"carom", version},
              {"file", report.file},
              {"law", report.has_law ? json(name_of(report.law)) : json()},
              {"digits", report.resolution.in_words()},
              {"exit_status", exit_status_of(report)},
              {"records", report.records},
              {"hold", report.held()},
              {"violated", report.violated},
              {"violated_at", report.violated_at},
              {"violated_left_out", report.violated - report.violated_at.size()},
              {"not_judged", report.not_judged},
              {"laws", laws},
              {"implied",
               {{"restitution", spread_record(report.restitution)},
                {"friction", spread_record(report.friction)},
                {"tangential_restitution", spread_record(report.tangential_restitution)}}},
              {"violations", violations},
              {"faults", faults},
              {"diagnosed_as", name_of(report.diagnosed_as)},
              {"worst", worst},
              {"unknown_fields", report.unknown},
              {"interrupted", report.interrupted}};
  if (!report.error.empty()) {
    record["error"] = report.error;
  }
  return record;
}

std::string records_junit(const RecordsReport& report) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("testsuites");
  root.append_attribute("name") = "carom";
  pugi::xml_node suite = add(root, "testsuite", {{"name", report.file}});
  std::string worst;
  for (const PlacedRecord& one : report.worst) {
    worst += one.place + ": " + one.broken.front().words + '\n';
  }
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  const auto add_case = [&](std::string_view name) {
    ++tests;
    return add(suite, "testcase", {{"classname", report.file}, {"name", name}, {"time", "0"}});
  };
  for (const properties::Invariant* invariant : judged_invariants(report)) {
    const pugi::xml_node test = add_case(invariant->name);
    const auto violated = report.violations.find(invariant);
    if (violated != report.violations.end()) {
      ++failures;
      add(test, "failure",
          {{"message", fmt::format("{} of {} records violate it", violated->second, report.records)},
           {"type", "violated"}},
          std::string(invariant->statement) + '\n' + worst);
    }
  }
  const pugi::xml_node reading = add_case("records");
  if (exit_status_of(report) == exit_usage) {
    ++errors;
    add(reading, "error", {{"message", "not judged to the end"}, {"type", "records"}},
        report.error.empty() ? verdict_of(report) : report.error);
  }
  for (pugi::xml_node node : {root, suite}) {
    node.append_attribute("tests") = static_cast<unsigned>(tests);
    node.append_attribute("failures") = static_cast<unsigned>(failures);
    node.append_attribute("errors") = static_cast<unsigned>(errors);
    node.append_attribute("skipped") = 0U;
    node.append_attribute("time") = "0";
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace carom::report
