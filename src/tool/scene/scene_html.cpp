// SPDX-License-Identifier: BSL-1.0
#include "scene/scene_html.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "report/environment.hpp"
#include "report/html_tables.hpp"
#include "report/markup.hpp"
#include "report/page.hpp"
#include "scene/scene_records.hpp"
#include "version.hpp"

namespace carom::tool {
namespace {

using properties::Cause;

pugi::xml_node add_section(pugi::xml_node main, const char* anchor, const char* heading) {
  const std::string id = std::string(anchor) + "-heading";
  const pugi::xml_node section = add(main, "section", {{"id", anchor}, {"aria-labelledby", id}});
  add(section, "h2", {{"id", id}}, heading);
  return section;
}

std::string joules(long double energy) { return fmt::format("{:.9g} J", static_cast<double>(energy)); }

void add_row(pugi::xml_node body, std::string_view name, const std::string& value) {
  const pugi::xml_node row = add(body, "tr");
  add(row, "th", {{"scope", "row"}}, name);
  add(row, "td", {{"class", "number"}}, value);
}

void add_ledger(pugi::xml_node main, const SceneRun& run) {
  const pugi::xml_node section = add_section(main, "ledger", "Ledger");
  add(section, "p", {},
      "Where each joule went. A cause is booked by its closed form; what the stored states differ by beyond that is "
      "rounding.");
  const pugi::xml_node table = add_table(section, "Energy by cause", "ledger");
  const pugi::xml_node body = add(table, "tbody");
  const properties::Ledger& ledger = run.ledger();
  add_row(body, "at first", joules(ledger.initial().total()));
  for (const Cause cause : properties::all_causes) {
    add_row(body, name_of(cause), joules(ledger.energy(cause)));
  }
  add_row(body, "at last", joules(ledger.present().total()));
  add_row(body, "rounding beside the scale of the energy",
          fmt::format("{:.2g}, allowed {:.2g}", run.relative_rounding(), run.rounding_limit()));
  add_row(
      body, "single roundings, without signs",
      fmt::format("{:.2g}", static_cast<double>(ledger.rounding_without_signs() / std::max(ledger.scale(), 1e-300L))));
}

void add_impulses(pugi::xml_node main, const SceneRun& run) {
  const pugi::xml_node section = add_section(main, "impulses", "Impulses");
  const properties::ImpulseJudge& judge = run.judge();
  std::string text = fmt::format("{} of {} judged, {} violated.", judge.judged(), judge.impulses(), judge.violated());
  if (const auto& bad = judge.first_bad()) {
    text +=
        fmt::format(" The first at t = {} s violates {}; its collision is in scene.json.", bad->time, bad->invariant);
  }
  add(section, "p", {}, text);
  if (judge.held().empty()) {
    return;
  }
  const pugi::xml_node table = add_table(section, "Impulses that each invariant holds for", "impulses");
  const pugi::xml_node body = add(table, "tbody");
  for (const auto& [name, count] : judge.held()) {
    add_row(body, name, std::to_string(count));
  }
}

void add_order(pugi::xml_node main, const SceneRun& run) {
  const pugi::xml_node section = add_section(main, "order", "Events and their order");
  const scene::Counts& counts = run.simulation().counts();
  std::vector<Fact> facts{{"events", std::to_string(counts.events)},
                          {"impacts of bodies", std::to_string(counts.impacts)},
                          {"impacts with planes", std::to_string(counts.plane_impacts)},
                          {"captures by level planes", std::to_string(counts.captures)},
                          {"changes of phase", std::to_string(counts.phases)},
                          {"slow contacts", std::to_string(counts.slow)},
                          {"most at one instant", std::to_string(counts.at_one_instant)},
                          {"orders decided exactly", std::to_string(counts.exact.orders)},
                          {"ties", std::to_string(counts.exact.ties)},
                          {"contacts decided exactly", std::to_string(counts.exact.predictions)},
                          {"gaps decided exactly", std::to_string(counts.exact.gaps)},
                          {"gaps asked for by conservative advancement", std::to_string(counts.advances)},
                          {"places moved clear", std::to_string(counts.moved_clear)}};
  if (const auto& validity = run.validity()) {
    facts.emplace_back("invalid states", std::to_string(validity->count));
    facts.emplace_back("pairs of paths checked",
                       fmt::format("{}, {} of them exactly", validity->pairs, validity->exact_pairs));
    facts.emplace_back("largest jump of a stored place", fmt::format("{:.2g} m", validity->largest_jump));
    facts.emplace_back("deepest overlap that would not have been seen", fmt::format("{:.2g} m", validity->unseen));
  } else {
    facts.emplace_back("invalid states", "not checked");
  }
  add_facts(section, facts);
}

}  // namespace

std::string scene_html(const SceneRun& run, bool has_replay_beside) {
  pugi::xml_document document;
  document.append_child(pugi::node_doctype).set_value("html");
  const pugi::xml_node html = add(document, "html", {{"lang", "en"}});
  add_head(html, "Carom: " + printable_text(run.scene().title));
  const pugi::xml_node body = add(html, "body");
  add(add(body, "header"), "h1", {}, run.scene().title);
  const pugi::xml_node main = add(body, "main");
  const pugi::xml_node summary = add_section(main, "summary", "Summary");
  add(summary, "p", {{"class", run.holds() ? "result exit-0" : "result exit-1"}}, scene_verdict(run));
  add_facts(summary, {{"law", std::string(name_of(run.scene().law))},
                      {"precision of impulses", std::string(name_of(run.scene().precision))},
                      {"spheres", std::to_string(run.scene().spheres.size())},
                      {"polyhedra", std::to_string(run.scene().polyhedra.size())},
                      {"planes", std::to_string(run.scene().planes.size())},
                      {"simulated", fmt::format("{:g} s of {:g} s", run.simulation().time(), run.scene().duration)},
                      {"ended early", run.ended_early()},
                      {"bodies whose spin changed", std::to_string(run.spins_changed())}});
  const pugi::xml_node links = add(summary, "p");
  for (const char* file :
       {"replay.html", "energy.svg", "momentum.svg", "spin.svg", "events.csv", "series.csv", "scene.json"}) {
    if (file != std::string_view("replay.html") || has_replay_beside) {
      add(links, "a", {{"href", file}}, file);
      add_text(links, " ");
    }
  }
  add_ledger(main, run);
  add_impulses(main, run);
  add_order(main, run);
  const Environment environment = this_environment();
  add_facts(add_section(main, "environment", "Environment"), {{"Carom", version},
                                                              {"date", environment.date},
                                                              {"compiler", environment.compiler},
                                                              {"processor", environment.processor}});
  return serialized(document);
}

}  // namespace carom::tool
